// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/curve_quantity.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "scene/eye_and_light.h"

namespace psm {
namespace {

constexpr double kDegrees = 1.0 / kRadiansPerDegree;
constexpr double kThetaStep = 0.5;  // degrees

/// Angle between the view and the direction to the light, at R's centroid for a position.
double theta_deg_of(const Analysis& a) {
  const CameraSettings& camera = a.experiment.camera;
  const glm::dvec3 seen = a.receivers_body.empty() ? camera.target : a.receivers_body.centroid();
  const glm::dvec3 v = safe_normalize(camera.target - camera.position);
  const glm::dvec3 l = safe_normalize(glm::dvec3(a.light) - a.light.w * seen);
  return kDegrees * std::atan2(glm::length(glm::cross(v, l)), glm::dot(v, l));
}

double error_value(CurveKind kind, const WarpModel<double>& model, double rho) {
  const WarpError<double> e = warp_error(model, rho, model.tan_phi);
  switch (kind) {
    case CurveKind::F_max:
      return e.F_max;
    case CurveKind::E_max:
      return e.E_max_line;
    case CurveKind::E_frustum:
      return e.E_max_frustum;
    default:
      return e.storage_factor;
  }
}

/// The largest angle of [0, high] below which `holds`, if it holds there and not at `high`.
std::optional<double> bisected(double high, const std::function<bool(double)>& holds) {
  double low = high;
  while (low > 0.0 && !holds(low)) low -= kThetaStep;
  if (!(low > 0.0) || low == high) return std::nullopt;
  high = low + kThetaStep;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (holds(middle) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

bool is_error(CurveKind kind) { return kind != CurveKind::lambda && kind != CurveKind::log_lambda && kind != CurveKind::rho; }

std::string angle_text(double theta_deg) { return number_text(std::round(100.0 * theta_deg) / 100.0) + "°"; }

}  // namespace

std::optional<Warp> warp_of(Technique technique) {
  switch (technique) {
    case Technique::uniform:
      return Warp::uniform;
    case Technique::lispsm:
      return Warp::lispsm;
    case Technique::lispsm_reference:
      return Warp::lispsm_reference;
    case Technique::glpr:
      return Warp::glpr;
    case Technique::gmnpr:
      return Warp::gmnpr;
    case Technique::minimax:
      return Warp::minimax;
    case Technique::minimax_frustum:
      return Warp::minimax_frustum;
    default:
      return {};
  }
}

CurveSetting curve_setting(const Analysis& a) {
  CurveSetting setting;
  setting.theta_deg = theta_deg_of(a);
  setting.current = warp_of(a.experiment.shadow.technique);
  const bool known = a.near && a.far && a.phi && *a.far > *a.near && *a.phi > 0.0;
  setting.from_papers = !known || a.experiment.view.curve_range == CurveFrustum::papers;
  if (!setting.from_papers) setting.range = {*a.near, *a.far, kDegrees * *a.phi};
  return setting;
}

bool is_over_both(CurveKind kind) { return kind == CurveKind::surface || kind == CurveKind::relief; }

bool is_over_z(CurveKind kind) { return kind == CurveKind::F_z || kind == CurveKind::E_z || is_over_both(kind); }

double curve_value(CurveKind kind, const CurveRange& range, double theta_deg, double z, Warp warp) {
  const WarpModel<double> model = curve_model(range, theta_deg);
  const WarpStrength<double> strength = warp_strength(warp, model);
  if (!strength.exists) return NAN;
  switch (kind) {
    case CurveKind::lambda:
    case CurveKind::log_lambda:
      return strength.lambda();
    case CurveKind::rho:
      return strength.rho;
    case CurveKind::F_z:
    case CurveKind::surface:
    case CurveKind::relief:
      return model.F(z, strength.rho);
    case CurveKind::E_z:
      return model.E(z, strength.rho);
    default:
      return error_value(kind, model, strength.rho);
  }
}

std::optional<double> worse_than_uniform_below(CurveKind kind, const CurveRange& range, Warp warp) {
  // F and E differ by sin(theta) for all techniques alike; E stays finite at 0.
  const CurveKind finite = kind == CurveKind::F_max || is_over_z(kind) ? CurveKind::E_max : kind;
  return bisected(90.0, [&](double theta) {
    const double error = curve_value(finite, range, theta, 0.0, warp);
    // Equal to the uniform map up to rounding is not worse.
    return error > (1.0 + 1e-9) * curve_value(finite, range, theta, 0.0, Warp::uniform);
  });
}

std::vector<CriticalAngle> critical_angles(CurveKind kind, const CurveSetting& setting) {
  const CurveRange& range = setting.range;
  std::vector<CriticalAngle> angles{{range.phi_deg, "θ = φ = " + angle_text(range.phi_deg), "θ = φ"}};
  if (is_over_z(kind)) return angles;
  if (!is_error(kind)) {
    const auto gone = [&](double theta) { return !warp_strength(Warp::gmnpr_eq4, curve_model(range, theta)).exists; };
    if (const auto theta = bisected(range.phi_deg, gone))
      angles.push_back({*theta, "λ of Eq. 4 = 0: " + angle_text(*theta), "Eq. 4 ends: " + angle_text(*theta)});
    return angles;
  }
  std::vector<Warp> compared{Warp::gmnpr, Warp::lispsm};
  const bool new_one = setting.current && *setting.current != Warp::uniform && *setting.current != Warp::gmnpr_eq4 &&
                       std::find(compared.begin(), compared.end(), *setting.current) == compared.end();
  if (new_one) compared.push_back(*setting.current);
  for (const Warp warp : compared)
    if (const auto theta = worse_than_uniform_below(kind, range, warp))
      angles.push_back({*theta, std::string(display_name(warp)) + " worse than uniform: " + angle_text(*theta),
                        std::string(display_name(warp)) + " worse: " + angle_text(*theta)});
  return angles;
}

const char* display_name(Warp warp) {
  constexpr const char* names[] = {"uniform", "LiSPSM", "LiSPSM code", "GLPR", "GMNPR", "GMNPR Eq. 4", "minimax", "minimax V"};
  return names[int(warp)];
}

}  // namespace psm
