// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/ray_tracer.h"

#include <cassert>

#include "math/projective.h"
#include "measure/triangle_soup.h"

namespace psm {
namespace {

std::unique_ptr<RayEngine> make_engine(const TriangleSoup& soup, RayTracer::Engine engine) {
#ifdef PSMLAB_EMBREE
  if (engine == RayTracer::Engine::embree) return make_embree_engine(soup);
#endif
  assert(engine == RayTracer::Engine::cgal && "built without Embree");
  (void)engine;
  return make_cgal_engine(soup);
}

}  // namespace

struct RayTracer::State {
  TriangleSoup soup;
  std::unique_ptr<RayEngine> engine;
};

RayTracer::Engine RayTracer::default_engine() {
#ifdef PSMLAB_EMBREE
  return Engine::embree;
#else
  return Engine::cgal;
#endif
}

RayTracer::RayTracer(const Scene& scene, Engine engine) : state_(std::make_unique<State>(State{TriangleSoup(scene), nullptr})) {
  state_->engine = make_engine(state_->soup, engine);
}

RayTracer::~RayTracer() = default;
RayTracer::RayTracer(RayTracer&&) noexcept = default;
RayTracer& RayTracer::operator=(RayTracer&&) noexcept = default;

std::optional<RayTracer::Hit> RayTracer::nearest(const glm::dvec3& origin, const glm::dvec3& direction, double from,
                                                 double to) const {
  const TriangleSoup& soup = state_->soup;
  const glm::dvec3 local = soup.to_local(origin), along = direction / soup.unit();
  const auto found = state_->engine->nearest(local, along, from, to);
  if (!found) return std::nullopt;
  const TriangleSoup::Triangle& triangle = soup.triangles()[*found];
  const glm::dvec3 normal = safe_normalize(triangle.normal());
  Hit hit;
  hit.distance = soup.distance(*found, local, along);
  // Back onto the plane: an eye far away has rounded the distance.
  glm::dvec3 at = local + hit.distance * along;
  at -= normal * glm::dot(normal, at - triangle.a);
  hit.point = {soup.to_world(at), glm::dot(normal, direction) > 0 ? -normal : normal};
  hit.mesh = triangle.mesh;
  hit.triangle = triangle.index;
  return hit;
}

bool RayTracer::shadowed(const SurfacePoint& point, const glm::dvec4& light) const {
  return state_->engine->blocked(state_->soup.to_local(point.position), state_->soup.light_to_local(light));
}

const char* RayTracer::engine() const { return state_->engine->name(); }

}  // namespace psm
