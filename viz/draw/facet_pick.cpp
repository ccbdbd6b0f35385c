// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/facet_pick.h"

#include <cmath>
#include <limits>

namespace psm {
namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// Corners as pixels and depth; none if one of them is not in front of the picture.
std::vector<glm::dvec3> on_picture(const ConvexBody& body, const std::vector<int>& facet, const glm::dmat4& clip_from_world,
                                   glm::dvec2 size) {
  std::vector<glm::dvec3> corners;
  for (const int v : facet) {
    const glm::dvec4 q = clip_from_world * glm::dvec4(body.vertices[std::size_t(v)], 1.0);
    if (!(q.w > 0.0)) return {};
    corners.push_back({(0.5 + 0.5 * q.x / q.w) * size.x, (0.5 - 0.5 * q.y / q.w) * size.y, q.z / q.w});
  }
  return corners;
}

/// Depth of the polygon's plane at the pixel, if the pixel lies inside; a polygon seen from its edge has no inside.
std::optional<double> depth_at(const std::vector<glm::dvec3>& corners, glm::dvec2 pixel) {
  int left = 0, right = 0;
  double twice_area = 0.0, depth = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec2 a = glm::dvec2(corners[i]) - pixel, b = glm::dvec2(corners[(i + 1) % corners.size()]) - pixel;
    (cross(a, b) >= 0.0 ? left : right)++;
  }
  if (left > 0 && right > 0) return {};
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {  // the largest triangle of the fan carries the plane
    const glm::dvec2 o(corners[0]), p = glm::dvec2(corners[i]) - o, q = glm::dvec2(corners[i + 1]) - o;
    const double area = cross(p, q);
    if (!(std::abs(area) > std::abs(twice_area))) continue;
    twice_area = area;
    const double s = cross(pixel - o, q) / area, t = cross(p, pixel - o) / area;
    depth = corners[0].z + s * (corners[i].z - corners[0].z) + t * (corners[i + 1].z - corners[0].z);
  }
  return std::abs(twice_area) > 1.0 ? std::optional<double>(depth) : std::nullopt;
}

}  // namespace

std::optional<PickedFacet> pick_facet(const ViewPicture& picture, const Analysis& analysis, glm::ivec2 size, glm::dvec2 pixel) {
  struct Named {
    const ConvexBody& body;
    Role role;
    const char* name;
  };
  std::optional<PickedFacet> nearest;
  double nearest_depth = std::numeric_limits<double>::infinity();
  for (const Named& named :
       {Named{analysis.receivers_body, Role::receivers_body, "R: "}, Named{analysis.caster_body, Role::caster_body, "H: "}}) {
    for (std::size_t i = 0; i < named.body.facets.size(); ++i) {
      const auto corners = on_picture(named.body, named.body.facets[i], picture.clip_from_world, glm::dvec2(size));
      const auto depth = corners.size() < 3 ? std::nullopt : depth_at(corners, pixel);
      if (!depth || !(*depth < nearest_depth - 1e-9 * std::abs(*depth))) continue;
      nearest_depth = *depth;
      nearest = PickedFacet{named.role, named.name + describe(named.body.planes[i]), {}};
      for (const glm::dvec3& c : corners) nearest->outline.push_back(glm::dvec2(c));
    }
  }
  return nearest;
}

}  // namespace psm
