// SPDX-License-Identifier: GPL-3.0-or-later
// plane_optimal: the vanishing plane through the light and the line where a receiver's plane meets the camera plane (Chong and
// Gortler 2004). On that receiver eye depth and map depth then cancel: every texel has the same size in the image.
#include <algorithm>
#include <cmath>

#include "scene/analysis_stages.h"
#include "scene/visible_receivers.h"

namespace psm {
namespace {

using glm::dvec3, glm::dvec4;

/// The experiment's plane, or the one that most visible points lie on; nothing where no face of a receiver sees the light.
std::optional<dvec4> receiver_plane(const Stages& s, Analysis& a) {
  if (s.x.shadow.receiver_plane) return *s.x.shadow.receiver_plane / glm::length(dvec3(*s.x.shadow.receiver_plane));
  if (!s.served.empty()) return largest_flat_area(s.served);
  const auto plane = largest_flat_area(face_points(s.view, a, 2));
  if (plane)
    note(a, "receiver_plane_from_bounds", "No visible points were given: the largest lit face of the receivers' body stands in.");
  return plane;
}

/// Scaled to mean 1 over the receivers; nothing where the mean is not positive.
std::optional<dvec4> mean_one(const dvec4& plane, std::span<const dvec3> receivers) {
  double sum = 0;
  for (const dvec3& p : receivers) sum += glm::dot(plane, dvec4(p, 1));
  if (!(sum > 0)) return std::nullopt;
  return plane * (double(receivers.size()) / sum);
}

/// The least t in [0, 1] for which (1 - t) c + t u has min >= least max over the receivers: the largest root of the pairs' linear
/// functions, each of which is negative at most up to there.
double least_turn(const dvec4& c, const dvec4& u, std::span<const dvec3> receivers, double least) {
  double t = 0;
  for (const dvec3& low : receivers)
    for (const dvec3& high : receivers) {
      const double at_c = glm::dot(c, dvec4(low, 1)) - least * glm::dot(c, dvec4(high, 1));
      const double at_u = glm::dot(u, dvec4(low, 1)) - least * glm::dot(u, dvec4(high, 1));
      if (at_c < 0) t = std::max(t, at_u > at_c ? std::min(1.0, at_c / (at_c - at_u)) : 1.0);
    }
  return t;
}

/// What min c / max c must reach on the receivers: a fifth of what the camera plane itself has there, near / far, and the more of
/// it the further below that the plane falls, up to a fifth: continuous, and never nearly singular where the plane fails clearly.
double least_ratio(const dvec4& c, double camera_plane, std::span<const dvec3> receivers) {
  const Range<double> r = value_range(c, receivers);
  const double allowed = 0.2 * camera_plane, got = r.min / r.max;
  return got >= allowed ? allowed : std::min(0.2, allowed + (allowed - got));
}

dvec4 uniform_instead(const Stages& s, Analysis& a, std::string code, std::string text) {
  note(a, std::move(code), std::move(text));
  a.technique_used = Technique::uniform;
  return s.uniform;
}

}  // namespace

dvec4 plane_of_receiver(Stages& s, Analysis& a, std::span<const dvec3> receivers) {
  const auto found = receiver_plane(s, a);
  if (!found)
    return uniform_instead(s, a, "no_receiver_plane",
                           "No visible face of the receivers sees the light: the uniform map is used.");
  const dvec4 G = glm::dot(*found, s.light) < 0 ? -*found : *found;
  const double g = glm::dot(G, s.light);
  const dvec4 K(s.view.forward, -glm::dot(s.view.forward, s.view.eye));
  if (g == 0)
    return uniform_instead(s, a, "receiver_holds_light", "The light lies in the receiver plane: the uniform map is used.");
  const auto c = mean_one(g * K - glm::dot(K, s.light) * G, receivers), u = mean_one(s.uniform, receivers);
  if (!c || !u)
    return uniform_instead(s, a, "plane_cuts_receivers", "The vanishing plane cuts the receivers: the uniform map is used.");
  const double least = least_ratio(*c, s.near / s.far, receivers);
  const double t = least_turn(*c, *u, receivers, least);
  if (t > 0)
    note(a, "plane_turned",
         "The receiver's plane would cut the receivers' body: it is turned towards the uniform map's, by this share.", t, 1.0);
  return (1 - t) * *c + t * *u;
}

}  // namespace psm
