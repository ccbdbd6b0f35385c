// SPDX-License-Identifier: GPL-3.0-or-later
// Embree finds candidates in float; what decides about a shadow is reckoned in double by the soup.
#include <embree3/rtcore.h>

#include <array>
#include <cassert>
#include <cmath>

#include "measure/triangle_soup.h"

namespace psm {
namespace {

/// A few rounding units of a float in a scene of size 2: how far rays start early, so that rounding misses no triangle.
constexpr double kFloatSlack = 4e-7;

/// What the filters need to know about the ray, after Embree's own part.
struct Query {
  RTCIntersectContext context;
  const TriangleSoup* soup = nullptr;
  glm::dvec3 origin{0.0}, direction{0.0};
  glm::dvec4 light{0.0};

  explicit Query(const TriangleSoup& s) : soup(&s) { rtcInitIntersectContext(&context); }
};

void drop_holes(const RTCFilterFunctionNArguments* args) {
  const Query& q = *reinterpret_cast<const Query*>(args->context);
  if (q.soup->hole(RTCHitN_primID(args->hit, args->N, 0), q.origin, q.direction)) args->valid[0] = 0;
}

void keep_blockers(const RTCFilterFunctionNArguments* args) {
  const Query& q = *reinterpret_cast<const Query*>(args->context);
  const std::uint32_t triangle = RTCHitN_primID(args->hit, args->N, 0);
  if (!q.soup->separates(triangle, q.origin, q.light) || q.soup->hole(triangle, q.origin, q.direction)) args->valid[0] = 0;
}

void set_ray(RTCRay& ray, const glm::dvec3& origin, const glm::dvec3& unit, double length) {
  ray = {};
  ray.org_x = float(origin.x), ray.org_y = float(origin.y), ray.org_z = float(origin.z);
  ray.dir_x = float(unit.x), ray.dir_y = float(unit.y), ray.dir_z = float(unit.z);
  ray.tfar = float(length);
  ray.mask = ~0u;
}

/// Narrows [from, to] to the part of the ray inside the box; false where none is left.
bool clip_to_box(const glm::dvec3& half, const glm::dvec3& origin, const glm::dvec3& unit, double& from, double& to) {
  for (int k = 0; k < 3; ++k) {
    const double reach = half[k] + kFloatSlack;
    if (unit[k] == 0) {
      if (std::abs(origin[k]) > reach) return false;
      continue;
    }
    const double a = (-reach - origin[k]) / unit[k], b = (reach - origin[k]) / unit[k];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  return from <= to;
}

class EmbreeEngine final : public RayEngine {
 public:
  explicit EmbreeEngine(const TriangleSoup& soup) : soup_(soup), device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    if (!soup.triangles().empty()) add_triangles();
    rtcCommitScene(scene_);
    assert(rtcGetDeviceError(device_) == RTC_ERROR_NONE);
  }
  ~EmbreeEngine() override {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  EmbreeEngine(const EmbreeEngine&) = delete;
  EmbreeEngine& operator=(const EmbreeEngine&) = delete;

  std::optional<std::uint32_t> nearest(const glm::dvec3& origin, const glm::dvec3& direction, double from,
                                       double to) const override {
    const double length = glm::length(direction);
    Query q(soup_);
    q.origin = origin;
    q.direction = direction / length;
    q.context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    from *= length, to *= length;
    // From the box on: floats would not do for an eye that is far from the scene.
    if (!clip_to_box(soup_.half_size(), origin, q.direction, from, to)) return std::nullopt;
    RTCRayHit ray{};
    set_ray(ray.ray, origin + from * q.direction, q.direction, to - from);
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &q.context, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return ray.hit.primID;
  }

  bool blocked(const glm::dvec3& point, const glm::dvec4& light) const override {
    const glm::dvec3 to_light = glm::dvec3(light) - light.w * point;
    const double length = glm::length(to_light);
    if (!(length > 0)) return false;
    Query q(soup_);
    q.origin = point;
    q.direction = to_light / length;
    q.light = light;
    q.context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    RTCRay ray;
    set_ray(ray, point - kFloatSlack * q.direction, q.direction,
            light.w == 0 ? std::numeric_limits<double>::infinity() : length + 2 * kFloatSlack);
    rtcOccluded1(scene_, &q.context, &ray);
    return ray.tfar < 0;
  }

  const char* name() const override { return "Embree " RTC_VERSION_STRING; }

 private:
  void add_triangles() {
    const auto& triangles = soup_.triangles();
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertex = static_cast<std::array<float, 3>*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(std::array<float, 3>), triangles.size() * 3));
    auto* index = static_cast<std::array<unsigned, 3>*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(std::array<unsigned, 3>), triangles.size()));
    unsigned next = 0;
    for (const TriangleSoup::Triangle& t : triangles) {
      for (const glm::dvec3& p : {t.a, t.b, t.c}) *vertex++ = {float(p.x), float(p.y), float(p.z)};
      *index++ = {next, next + 1, next + 2};
      next += 3;
    }
    rtcSetGeometryOccludedFilterFunction(geometry, keep_blockers);
    if (soup_.has_holes()) rtcSetGeometryIntersectFilterFunction(geometry, drop_holes);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
  }

  const TriangleSoup& soup_;
  RTCDevice device_;
  RTCScene scene_;
};

}  // namespace

std::unique_ptr<RayEngine> make_embree_engine(const TriangleSoup& soup) { return std::make_unique<EmbreeEngine>(soup); }

}  // namespace psm
