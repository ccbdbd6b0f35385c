// SPDX-License-Identifier: GPL-3.0-or-later
// The explorer: every direction or position that the light could have, by what the projection makes of it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "draw/chart.h"
#include "draw/chart_labels.h"
#include "draw/explorer_map.h"
#include "draw/sketch.h"
#include "scene/curve_quantity.h"
#include "scene/eye_and_light.h"

namespace psm {
namespace {

using glm::dvec2, glm::dvec3, glm::dvec4;

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr int kSides = 120;
constexpr double kLine = kChartLine;

dvec4 on_page(const dvec2& p) { return {p, 0.0, 1.0}; }

/// Where a plane through the body's inside cuts it: corners in order around their middle.
std::vector<dvec3> cut(const ConvexBody& body, const dvec3& point, const dvec3& normal) {
  std::vector<dvec3> corners;
  for (const auto& [i, j] : body_edges(body)) {
    const double a = glm::dot(normal, body.vertices[i] - point), b = glm::dot(normal, body.vertices[j] - point);
    if ((a < 0.0) != (b < 0.0)) corners.push_back(glm::mix(body.vertices[i], body.vertices[j], a / (a - b)));
  }
  return corners;
}

class ExplorerView {
 public:
  ExplorerView(const Analysis& analysis, const dvec2& page)
      : analysis_(analysis), page_(page), map_(explorer_map(analysis, page)), setting_(curve_setting(analysis)) {}

  ViewPicture picture() {
    if (map_.directions)
      directions();
    else
      positions();
    light();
    words();
    ViewPicture picture;
    picture.id = ViewId::explorer;
    picture.title = map_.directions ? "Explorer: every light direction"
                    : analysis_.experiment.view.explorer_slice == ExplorerSlice::side
                        ? "Explorer: light positions, from the side"
                        : "Explorer: light positions, from above the camera";
    picture.scene = ScenePicture::none;
    picture.clip_from_world = picture.clip_from_list = clip_from_page(page_);
    picture.list = std::move(list_);
    return picture;
  }

 private:
  void line(const dvec2& a, const dvec2& b, const Pen& pen) {
    list_.lines.push_back({on_page(a), on_page(b), pen.role, pen.width, pen.style, false, pen.opacity, pen.opacity});
  }
  void text(const dvec2& at, const std::string& words, Role role, const dvec2& pivot) {
    list_.texts.push_back({on_page(at), words, role, pivot});
  }
  /// Finds a place beside what it names.
  void label(const dvec2& at, const std::string& words, Role role, int priority) {
    list_.labels.push_back({on_page(at), words, role, priority});
  }
  void polygon(const std::vector<dvec2>& corners, Role role, double alpha) {
    DrawFill fill{{}, role, alpha};
    for (const dvec2& p : corners) fill.corners.push_back(on_page(p));
    list_.fills.push_back(std::move(fill));
  }

  /// All directions at theta(roll) from the view.
  template <class Theta>
  void closed_curve(Theta theta, const Pen& pen) {
    dvec2 last = map_.page_of(theta(0.0), 0.0);
    for (int i = 1; i <= kSides; ++i) {
      const double roll = kTurn * i / kSides;
      const dvec2 next = map_.page_of(theta(roll), roll);
      line(last, next, pen);
      last = next;
    }
  }
  void circle(double theta_deg, const Pen& pen) {
    closed_curve([&](double) { return glm::radians(theta_deg); }, pen);
  }

  void directions() {
    std::vector<dvec2> inner;
    for (int i = 0; i < kSides; ++i) {
      const double a = kTurn * i / kSides, b = kTurn * (i + 1) / kSides;
      inner.push_back(map_.page_of(kTurn / 4, a));
      polygon({map_.page_of(kTurn / 4, a), map_.page_of(kTurn / 2, a), map_.page_of(kTurn / 2, b), map_.page_of(kTurn / 4, b)},
              Role::light_inverted, 0.30);
    }
    polygon(inner, Role::light_point, 0.22);
    for (const double theta : {30.0, 60.0, 120.0, 150.0}) {
      circle(theta, {Role::neutral, 1.0, LineStyle::solid, 0.35});
      if (!is_small()) text(map_.page_of(glm::radians(theta), -kTurn / 8), short_number(theta) + "°", Role::neutral, {0.5, 0.5});
    }
    horizon();
    warp_angles();
    circle(90.0, {Role::infinity, 3.0});
    circle(180.0, {Role::neutral, 1.5});
    list_.points.push_back({on_page(map_.middle), Role::frustum, 4.0});
    text(map_.middle + dvec2(7.0, 0.0), is_small() ? "θ = 0" : "view direction, θ = 0", Role::frustum, {0.0, 0.5});
    name_regions();
  }

  bool is_small() const { return map_.scale < 190.0; }

  void name_regions() {
    if (is_small()) {
      text(map_.page_of(glm::radians(45.0), -kTurn / 4), "point light", Role::light_point, {0.5, 0.5});
      text(map_.page_of(glm::radians(90.0), -kTurn / 4), "w = 0", Role::infinity, {0.5, 0.5});
      text(map_.page_of(glm::radians(128.0), -kTurn / 4), "inverted, order reversed", Role::light_inverted, {0.5, 0.5});
      return;
    }
    text(map_.page_of(glm::radians(52.0), -kTurn / 4), "point light, order kept", Role::light_point, {0.5, 0.5});
    text(map_.page_of(glm::radians(90.0), -kTurn / 4), "w = 0: stays directional", Role::infinity, {0.5, 0.5});
    text(map_.page_of(glm::radians(112.0), -kTurn / 4), "inverted point light, order reversed", Role::light_inverted, {0.5, 0.5});
    text(map_.page_of(glm::radians(180.0), -kTurn / 4) - dvec2(0.0, 3.0), "rim: straight behind, 180°", Role::neutral,
         {0.5, 1.0});
  }

  /// Directions in the world's horizontal plane: the sun of a scene on the ground stays on one side.
  void horizon() {
    std::optional<dvec2> last;
    for (int i = 0; i <= kSides; ++i) {
      const double azimuth = kTurn * i / kSides;
      const dvec2 next = map_.page_of_direction({std::sin(azimuth), 0.0, std::cos(azimuth)});
      // Through the opposite of the view direction it jumps from one side of the rim to the other.
      if (last && glm::length(next - *last) < 0.4 * map_.scale) line(*last, next, {Role::neutral, 1.5, LineStyle::dashed});
      last = next;
    }
    const dvec3 right = glm::dvec3(map_.right.x, 0.0, map_.right.z);
    if (glm::length(right) > 0.5 && !is_small())
      text(map_.page_of_direction(-right + 0.35 * map_.forward), "horizon", Role::neutral, {0.5, 1.0});
    const dvec2 zenith = map_.page_of_direction({0.0, 1.0, 0.0});
    list_.points.push_back({on_page(zenith), Role::neutral, 3.5});
    if (!is_small()) text(zenith + dvec2(6.0, 0.0), "straight up", Role::neutral, {0.0, 0.5});
  }

  /// phi in the plane of the view and a light at this roll (FORMULAS, section 1), degrees.
  double phi_deg(double roll) const {
    const ViewFrame view = camera_frame(analysis_.experiment);
    const double tan_phi = std::abs(std::cos(roll)) * view.tan_x + std::abs(std::sin(roll)) * view.tan_y;
    return glm::degrees(std::atan(tan_phi));
  }

  /// theta = phi, and below which angle the current technique is worse than the uniform map; on both sides, as the model is.
  void warp_angles() {
    const Pen phi{Role::frustum, 1.5, LineStyle::dashed};
    closed_curve([&](double roll) { return glm::radians(phi_deg(roll)); }, phi);
    closed_curve([&](double roll) { return glm::radians(180.0 - phi_deg(roll)); }, phi);
    const bool light_at_left = map_.page_of(analysis_).x < map_.middle.x;
    const double at = (light_at_left ? 0.14 : 0.36) * kTurn;
    text(map_.page_of(glm::radians(phi_deg(at)), at), "θ = φ", Role::frustum, {light_at_left ? 0.0 : 1.0, 1.0});
    const auto warp = setting_.current;
    if (setting_.from_papers || !warp || *warp == Warp::uniform) return;
    std::vector<double> angles;  // of the four symmetric quarters, the first
    constexpr int steps = 16;
    for (int i = 0; i <= steps; ++i) {
      const auto found =
          worse_than_uniform_below(CurveKind::F_max, {setting_.range.n, setting_.range.f, phi_deg(kTurn / 4 * i / steps)}, *warp);
      if (!found) return;
      angles.push_back(glm::radians(*found));
    }
    const auto theta = [&](double roll) {
      const double quarter = std::abs(std::remainder(roll, kTurn / 2)) / (kTurn / 4) * steps;
      const int i = std::min(steps - 1, int(quarter));
      return glm::mix(angles[std::size_t(i)], angles[std::size_t(i) + 1], quarter - i);
    };
    const Pen pen{Role::vanishing_plane, 2.0};
    closed_curve(theta, pen);
    closed_curve([&](double roll) { return kTurn / 2 - theta(roll); }, pen);
    text(map_.page_of(theta(kTurn / 4), kTurn / 4) - dvec2(0.0, 8.0),
         std::string(display_name(*warp)) + (is_small() ? " worse" : " worse than uniform"), Role::vanishing_plane, {0.5, 0.5});
  }

  void positions() {
    const double plane = std::clamp(map_.middle.x, map_.min.x, map_.max.x);
    polygon({map_.min, {plane, map_.min.y}, {plane, map_.max.y}, {map_.min.x, map_.max.y}}, Role::light_inverted, 0.30);
    polygon({{plane, map_.min.y}, {map_.max.x, map_.min.y}, map_.max, {plane, map_.max.y}}, Role::light_point, 0.22);
    section(analysis_.receivers_body, Role::receivers_body, 0.45, LineStyle::solid);
    section(analysis_.scene_body, Role::scene_bounds, 0.0, LineStyle::dashed);
    frustum();
    line({map_.middle.x, map_.min.y}, {map_.middle.x, map_.max.y}, {Role::infinity, 3.0});
    list_.points.push_back({on_page(map_.middle), Role::frustum, 5.0});
    label(map_.middle, "eye", Role::frustum, 1);
    name_sides();
  }

  /// The first of these wordings whose lines fit between `left` and `right`, from `y` downwards or, at the map's lower end, up.
  /// `pivot`: 0 stands at the left, 0.5 in the middle.
  void text_between(double left, double right, double y, double pivot, Role role,
                    const std::vector<std::vector<std::string>>& wordings) {
    constexpr double gap = 6.0;
    for (const auto& lines : wordings) {
      const bool fits = std::all_of(lines.begin(), lines.end(),
                                    [&](const std::string& line) { return chart_text_width(line) <= right - left - 2.0 * gap; });
      if (!fits) continue;
      const double top = y < map_.max.y - 4.0 ? y : y - kLine * double(lines.size());
      for (std::size_t i = 0; i < lines.size(); ++i)
        text({glm::mix(left + gap, right - gap, pivot), top + kLine * double(i)}, lines[i], role, {pivot, 0.0});
      return;
    }
  }

  void name_sides() {
    const double plane = std::clamp(map_.middle.x, map_.min.x, map_.max.x), bottom = map_.max.y - 4.0;
    text_between(map_.min.x, plane, bottom, 0.5, Role::light_inverted,
                 {{"inverted point, order reversed"}, {"inverted point,", "order reversed"}, {"inverted,", "order", "reversed"}});
    text_between(plane, map_.max.x, bottom, 0.5, Role::light_point,
                 {{"point light, order kept"}, {"point light,", "order kept"}, {"point,", "order kept"}});
    text_between(plane, map_.max.x, map_.min.y + 2.0, 0.0, Role::infinity,
                 {{"camera plane, w = 0: directional"}, {"camera plane,", "w = 0: directional"}, {"w = 0"}});
  }

  void section(const ConvexBody& body, Role role, double alpha, LineStyle style) {
    const dvec3 normal = glm::cross(map_.forward, map_.across);
    std::vector<dvec2> corners;
    for (const dvec3& p : cut(body, map_.eye, normal)) corners.push_back(map_.page_of_position(p));
    if (corners.size() < 3) return;
    dvec2 middle(0.0);
    for (const dvec2& p : corners) middle += p / double(corners.size());
    std::sort(corners.begin(), corners.end(), [&](const dvec2& p, const dvec2& q) {
      return std::atan2(p.y - middle.y, p.x - middle.x) < std::atan2(q.y - middle.y, q.x - middle.x);
    });
    if (alpha > 0.0) polygon(corners, role, alpha);
    for (std::size_t i = 0; i < corners.size(); ++i) clipped(corners[i], corners[(i + 1) % corners.size()], {role, 1.5, style});
    const std::string name = "R: a light here needs six maps";
    if (alpha > 0.0) label(middle, 2.0 * chart_text_width(name) < map_.max.x - map_.min.x ? name : "R: six maps", role, 2);
  }

  void clipped(const dvec2& a, const dvec2& b, const Pen& pen) {
    const Box box{{map_.min, -1.0}, {map_.max, 1.0}};
    if (const auto piece = clip_segment(on_page(a), on_page(b), box)) line(dvec2(piece->a), dvec2(piece->b), pen);
  }

  void frustum() {
    const Experiment& e = analysis_.experiment;
    const ViewFrame view = camera_frame(e);
    const double tangent = e.view.explorer_slice == ExplorerSlice::side ? view.tan_y : view.tan_x;
    const double reach = (map_.max.x - map_.middle.x) / map_.scale,
                 far = std::min(e.camera.far, 2.0 * std::max(reach, e.camera.near));
    const auto at = [&](double z, double side) { return map_.middle + map_.scale * z * dvec2(1.0, side * tangent); };
    const Pen pen{Role::frustum, 2.0};
    for (const double side : {-1.0, 1.0}) clipped(at(e.camera.near, side), at(far, side), pen);
    for (const double z : {e.camera.near, e.camera.far})
      if (std::isfinite(z)) clipped(at(z, -1.0), at(z, 1.0), pen);
    label(at(0.6 * std::min(far, reach), -0.8), "V", Role::frustum, 0);
  }

  /// The handle.
  void light() {
    const dvec2 at = map_.clamped(map_.page_of(analysis_));
    for (int i = 0; i < 8; ++i) {
      const dvec2 ray(std::cos(kTurn * i / 8), std::sin(kTurn * i / 8));
      line(at + 10.0 * ray, at + 15.0 * ray, {Role::light, 2.5});
    }
    list_.points.push_back({on_page(at), Role::light, 8.0});
  }

  void words() {
    const PageRect room = beside_explorer_map(page_);
    if (room.max.x < room.min.x) return;
    const LightCase& c = analysis_.light_case;
    double y = room.min.y;
    const auto say = [&](const std::string& words, Role role) {
      text({room.min.x, y}, words, role, {0.0, 0.0});
      y += kLine + 3.0;
    };
    const bool inverted = c.post == PostLight::inverted_point, directional = c.post == PostLight::directional;
    const Role role = inverted ? Role::light_inverted : directional ? Role::infinity : Role::light_point;
    say("This light", Role::text);
    say(std::string(map_.directions ? "w = v·l = " : "w = v·(l − e) = ") + short_number(c.w, 4), role);
    say(inverted ? "w < 0: inverted point light" : directional ? "w = 0: directional light" : "w > 0: point light", role);
    say(c.reversed_order ? "naive order: reversed" : "naive order: kept", role);
    say("θ = " + short_number(setting_.theta_deg, 4) + "° to the view", Role::text);
    if (c.inside_receivers) say("inside R: six maps", Role::receivers_body);
    if (!map_.directions && off_slice() > 0.0) say(short_number(off_slice()) + " off this slice", Role::text);
  }

  double off_slice() const {
    const dvec3 normal = glm::cross(map_.forward, map_.across);
    const double off = std::abs(glm::dot(normal, dvec3(analysis_.light) - map_.eye));
    return off > 1e-9 * glm::length(dvec3(analysis_.light) - map_.eye) ? off : 0.0;
  }

  const Analysis& analysis_;
  dvec2 page_;
  ExplorerMap map_;
  CurveSetting setting_;
  DrawList list_;
};

}  // namespace

ViewPicture describe_explorer(const Analysis& analysis, const glm::dvec2& page) { return ExplorerView(analysis, page).picture(); }

}  // namespace psm
