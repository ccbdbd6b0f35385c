// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's tree of boxes with exact predicates: slower than Embree, and nothing slips between two triangles.
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/version.h>

#include "measure/triangle_soup.h"

namespace psm {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 point_of(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

class CgalEngine final : public RayEngine {
 public:
  explicit CgalEngine(const TriangleSoup& soup) : soup_(soup) {
    triangles_.reserve(soup.triangles().size());
    for (const auto& t : soup.triangles()) triangles_.emplace_back(point_of(t.a), point_of(t.b), point_of(t.c));
    tree_.insert(triangles_.cbegin(), triangles_.cend());
    tree_.build();
  }

  std::optional<std::uint32_t> nearest(const glm::dvec3& origin, const glm::dvec3& direction, double from,
                                       double to) const override {
    return first(origin, direction, [&](std::uint32_t t) {
      const double at = soup_.distance(t, origin, direction);
      return at < from || at > to || soup_.hole(t, origin, direction);
    });
  }

  bool blocked(const glm::dvec3& point, const glm::dvec4& light) const override {
    const glm::dvec3 to_light = glm::dvec3(light) - light.w * point;
    return to_light != glm::dvec3(0.0) && first(point, to_light, [&](std::uint32_t t) {
                                            return !soup_.separates(t, point, light) || soup_.hole(t, point, to_light);
                                          }).has_value();
  }

  const char* name() const override { return "CGAL " CGAL_VERSION_STR " AABB tree"; }

 private:
  template <class Skip>
  std::optional<std::uint32_t> first(const glm::dvec3& origin, const glm::dvec3& direction, const Skip& skip) const {
    if (triangles_.empty()) return std::nullopt;
    const auto index = [&](Triangles::const_iterator t) { return std::uint32_t(t - triangles_.cbegin()); };
    const Kernel::Ray_3 ray(point_of(origin), Kernel::Vector_3(direction.x, direction.y, direction.z));
    const auto found = tree_.first_intersected_primitive(ray, [&](Triangles::const_iterator t) { return skip(index(t)); });
    if (!found) return std::nullopt;
    return index(*found);
  }

  const TriangleSoup& soup_;
  Triangles triangles_;
  Tree tree_;
};

}  // namespace

std::unique_ptr<RayEngine> make_cgal_engine(const TriangleSoup& soup) { return std::make_unique<CgalEngine>(soup); }

}  // namespace psm
