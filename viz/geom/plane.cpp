// SPDX-License-Identifier: GPL-3.0-or-later
#include "geom/plane.h"

#include <cmath>

namespace psm {

Plane Plane::through(const glm::dvec3& normal, const glm::dvec3& point, double distance, PlaneId plane_id) {
  Plane p(normal, distance - glm::dot(normal, point));
  p.anchor = point;
  p.offset = distance;
  p.id = plane_id;
  return p;
}

Plane Plane::silhouette(const Plane& kept, const Plane& dropped, const glm::dvec4& light) {
  Plane p(glm::dot(glm::dvec4(kept), light) * dropped - glm::dot(glm::dvec4(dropped), light) * kept);
  p.id = PlaneId::silhouette;
  p.edge = std::make_shared<const SilhouetteOf>(SilhouetteOf{kept, dropped, light});
  return p;
}

bool same_exact_definition(const Plane& p, const Plane& q) {
  if (!p.edge && !q.edge) return p.anchor == q.anchor && p.offset == q.offset;
  if (p.edge == q.edge) return true;
  return p.edge && q.edge && p.edge->light == q.edge->light && same_definition(p.edge->kept, q.edge->kept) &&
         same_definition(p.edge->dropped, q.edge->dropped);
}

std::string describe(const Plane& plane) {
  static const char* const names[] = {"given", "left",  "right", "bottom", "top",   "near", "far",      "min x",
                                      "max x", "min y", "max y", "min z",  "max z", "hull", "infinity", "silhouette"};
  if (plane.edge) return "light and the edge of " + describe(plane.edge->kept) + " and " + describe(plane.edge->dropped);
  const char* name = names[int(plane.id)];
  if (plane.id >= PlaneId::left && plane.id <= PlaneId::far) return std::string(plane.of_light ? "L " : "V ") + name;
  if (plane.id >= PlaneId::min_x && plane.id <= PlaneId::hull) return std::string("S ") + name;
  return name;
}

}  // namespace psm
