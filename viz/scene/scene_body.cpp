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

/// Where a spot stands inside S its pyramid starts at a named near distance, so that the light is not one of its own receivers.
std::vector<Plane> light_planes(const Stages& s, const ConvexBody& scene, double& near) {
  if (s.x.light.type != LightType::spot) return {};
  const ViewFrame spot = spot_frame(s.x.light);
  if (contains(scene.planes, s.light)) {
    double reach = 0;
    for (const glm::dvec3& v : scene.vertices) reach = std::max(reach, spot.depth(v));
    near = 1e-3 * reach;
  }
  return pyramid_planes(spot, near);
}

SceneBodies bodies_of(const Stages& s, ConvexBody scene) {
  SceneBodies b;
  b.light_planes = light_planes(s, scene, b.light_near);
  b.lit = clip(scene, b.light_planes);
  b.receivers = clip(b.lit, s.view_planes);
  b.scene = std::move(scene);
  return b;
}

/// The meshes that reach into hull(V + l) ∩ box ∩ L, from the light on. One wholly outside neither shows nor shades what shows.
std::vector<int> casters_that_matter(const Stages& s, const SceneBodies& box) {
  const ConvexBody from_light = box.light_near > 0 ? clip(box.scene, pyramid_planes(spot_frame(s.x.light))) : box.lit;
  const ConvexBody reach = clip(from_light, s.view_hull);
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

SceneBodies scene_bodies(const Stages& s, Analysis& a) {
  Bounds b = s.scene.bounds;
  if (b.empty()) b.min = b.max = s.view.at(0, 0, s.x.camera.near);
  SceneBodies box = bodies_of(s, box_body(b.min, b.max));
  const SceneBody asked = s.x.shadow.scene_body;
  if (asked == SceneBody::box) return box;
  const std::vector<int> casters = casters_that_matter(s, box);
  if (casters.empty()) {
    note(a, "scene_body_box", "S is the scene's box: no caster can matter.");
    return box;
  }
  SceneBodies hull = bodies_of(s, hull_body(s.scene.hulls, casters));
  const double left = part_left(s, box.receivers, hull.receivers);
  const std::optional<double> limit = asked == SceneBody::automatic ? std::optional(kWorthwhile) : std::nullopt;
  if (limit && left > *limit) {
    note(a, "scene_body_box",
         "S is the scene's box: the hull would leave " + percent(left) + " of R's area as the light sees it.", left, limit);
    return box;
  }
  note(a, "scene_body_hull",
       "S is a hull of the " + std::to_string(casters.size()) + " of " + std::to_string(s.scene.meshes.size()) +
           " meshes that can matter, with " + std::to_string(hull.scene.facets.size()) + " facets: it leaves " + percent(left) +
           " of R's area as the light sees it.",
       left, limit);
  a.scene_body_used = SceneBody::hull;
  return hull;
}

}  // namespace psm
