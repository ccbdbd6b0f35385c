// SPDX-License-Identifier: GPL-3.0-or-later
// S in two grains: the box of all meshes, and a hull of the casters that can matter.
#include <cmath>

#include "geom/point_hulls.h"
#include "scene/analysis_stages.h"

namespace psm {
namespace {

/// Auto takes the hull where it leaves at most this part of R's area as the light sees it, which is what the map's window is
/// spent on. (R's volume tells little: above a wide ground the hull halves it and leaves the window as it was.)
constexpr double kWorthwhile = 0.9;

std::vector<Plane> whole_cone(const LightSettings& l) {
  return l.type == LightType::spot ? pyramid_planes(spot_frame(l)) : std::vector<Plane>();
}

/// The meshes that reach into hull(V + l) ∩ box ∩ L. One wholly outside neither shows nor shades what shows.
std::vector<int> casters_that_matter(const Stages& s, const ConvexBody& lit_box) {
  const ConvexBody reach = clip(lit_box, frustum_hull_with_light(s.view_planes, s.light));
  std::vector<int> chosen;
  const auto& sets = s.scene.hulls.sets;
  for (std::size_t i = 0; i < sets.size(); ++i)
    if (!sets[i].empty() && !reach.empty() && !misses(reach, sets[i].min, sets[i].max)) chosen.push_back(int(i));
  return chosen;
}

/// Of the body's outline across `direction`: every ray along it that meets the body meets two facets.
double area_across(const ConvexBody& body, const glm::dvec3& direction) {
  double twice = 0;
  for (const auto& f : body.facets) {
    glm::dvec3 area(0);
    for (std::size_t k = 1; k + 1 < f.size(); ++k)
      area += glm::cross(body.vertices[f[k]] - body.vertices[f[0]], body.vertices[f[k + 1]] - body.vertices[f[0]]) / 2.0;
    twice += std::abs(glm::dot(area, direction));
  }
  return twice / 2;
}

/// What the hull leaves of R's area, seen along the light's ray through the box's R; 1 where there is none to compare.
double part_left(const Stages& s, const ConvexBody& box_receivers, const ConvexBody& hull_receivers) {
  if (box_receivers.empty()) return 1;
  const glm::dvec3 ray = safe_normalize(glm::dvec3(s.light) - s.light.w * box_receivers.centroid());
  const double whole = area_across(box_receivers, ray);
  return whole > 0 ? area_across(hull_receivers, ray) / whole : 1;
}

std::string percent(double fraction) { return number_text(std::round(1000 * fraction) / 10) + " %"; }

}  // namespace

void set_scene_body(const Stages& s, Analysis& a) {
  Bounds b = s.scene.bounds;
  if (b.empty()) b.min = b.max = s.view.at(0, 0, s.x.camera.near);
  a.scene_body = box_body(b.min, b.max);
  const SceneBody asked = s.x.shadow.scene_body;
  if (asked == SceneBody::box) return;
  const std::vector<Plane> cone = whole_cone(s.x.light);
  const ConvexBody lit_box = clip(a.scene_body, cone);
  const std::vector<int> casters = casters_that_matter(s, lit_box);
  if (casters.empty()) return note(a, "scene_body_box", "S is the scene's box: no caster can matter.");
  ConvexBody hull = hull_body(s.scene.hulls, casters);
  const double left = part_left(s, clip(lit_box, s.view_planes), clip(clip(hull, cone), s.view_planes));
  const std::optional<double> limit = asked == SceneBody::automatic ? std::optional(kWorthwhile) : std::nullopt;
  if (limit && left > *limit)
    return note(a, "scene_body_box",
                "S is the scene's box: the hull would leave " + percent(left) + " of R's area as the light sees it.", left,
                limit);
  note(a, "scene_body_hull",
       "S is a hull of the " + std::to_string(casters.size()) + " of " + std::to_string(s.scene.meshes.size()) +
           " meshes that can matter, with " + std::to_string(hull.facets.size()) + " facets: it leaves " + percent(left) +
           " of R's area as the light sees it.",
       left, limit);
  a.scene_body = std::move(hull);
  a.scene_body_used = SceneBody::hull;
}

}  // namespace psm
