// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/triangle_soup.h"

#include <algorithm>
#include <cmath>

namespace psm {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kSmallestUnit = 1e-100;  // distances in it still have squares; a smaller scene is a point

bool finite(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// Calls f(mesh, index, corners) for every triangle with finite coordinates.
template <class F>
void for_each_finite(const Scene& scene, const F& f) {
  for (std::uint32_t m = 0; m < scene.meshes.size(); ++m) {
    const Mesh& mesh = scene.meshes[m];
    for (std::uint32_t t = 0; std::size_t(t) * 3 + 2 < mesh.triangles.size(); ++t) {
      const std::uint32_t* corner = &mesh.triangles[std::size_t(t) * 3];
      if (std::all_of(corner, corner + 3, [&](std::uint32_t i) { return finite(mesh.positions[i]); })) f(m, t, corner);
    }
  }
}

int wrapped(int i, int size, Wrap wrap) { return wrap == Wrap::repeat ? (i + size) % size : std::clamp(i, 0, size - 1); }

/// Into [0, 1] as the sampler would.
double wrapped(double x, Wrap wrap) {
  if (wrap == Wrap::clamp) return std::clamp(x, 0.0, 1.0);
  if (wrap == Wrap::repeat) return x - std::floor(x);
  const double turn = x - 2 * std::floor(x / 2);
  return turn > 1 ? 2 - turn : turn;
}

double sample_alpha(const Texture& t, const glm::dvec2& at) {
  const double x = wrapped(at.x, t.wrap_u) * t.width, y = wrapped(at.y, t.wrap_v) * t.height;
  const auto texel = [&](int i, int j) {
    const auto row = std::size_t(wrapped(j, t.height, t.wrap_v)), column = std::size_t(wrapped(i, t.width, t.wrap_u));
    return t.rgba[(row * std::size_t(t.width) + column) * 4 + 3] / 255.0;
  };
  if (t.nearest) return texel(int(x), int(y));
  const int i = int(std::floor(x - 0.5)), j = int(std::floor(y - 0.5));
  const double fx = x - 0.5 - i, fy = y - 0.5 - j;
  return glm::mix(glm::mix(texel(i, j), texel(i + 1, j), fx), glm::mix(texel(i, j + 1), texel(i + 1, j + 1), fx), fy);
}

/// Weights of b and c at a point of the triangle's plane.
glm::dvec2 weights(const TriangleSoup::Triangle& t, const glm::dvec3& p) {
  const glm::dvec3 n = t.normal(), d = p - t.a;
  return glm::dvec2(glm::dot(n, glm::cross(d, t.c - t.a)), glm::dot(n, glm::cross(t.b - t.a, d))) / glm::dot(n, n);
}

}  // namespace

TriangleSoup::TriangleSoup(const Scene& scene) {
  Bounds bounds;
  for_each_finite(scene, [&](std::uint32_t m, std::uint32_t, const std::uint32_t* corner) {
    for (int k = 0; k < 3; ++k) bounds.add(scene.meshes[m].positions[corner[k]]);
  });
  if (bounds.empty()) return;
  const glm::dvec3 half = 0.5 * (bounds.max - bounds.min);
  origin_ = bounds.min + half;
  unit_ = std::max({half.x, half.y, half.z});
  if (!(unit_ > kSmallestUnit) || !std::isfinite(unit_)) unit_ = 1;
  half_ = half / unit_;
  // Coordinates of world points carry half an epsilon of their size; a few operations follow.
  rounding_ = 16 * kEpsilon * (2 + glm::length(origin_) / unit_);
  for_each_finite(scene, [&](std::uint32_t m, std::uint32_t t, const std::uint32_t*) { add(scene, m, t); });
  if (has_holes()) textures_ = scene.textures;
}

void TriangleSoup::add(const Scene& scene, std::uint32_t mesh_index, std::uint32_t index) {
  const Mesh& mesh = scene.meshes[mesh_index];
  const std::uint32_t* corner = &mesh.triangles[std::size_t(index) * 3];
  const Triangle t{to_local(mesh.positions[corner[0]]), to_local(mesh.positions[corner[1]]), to_local(mesh.positions[corner[2]]),
                   mesh_index, index};
  if (!(glm::length(t.normal()) > 4 * kEpsilon * glm::length(t.b - t.a) * glm::length(t.c - t.a))) return;
  triangles_.push_back(t);
  const Material& material = scene.materials[std::size_t(mesh.material)];
  cutout_of_.push_back(material.alpha_cutoff > 0 ? std::int32_t(cutouts_.size()) : -1);
  if (!(material.alpha_cutoff > 0)) return;
  const bool textured = material.texture >= 0 && std::size_t(material.texture) < scene.textures.size() &&
                        !scene.textures[std::size_t(material.texture)].rgba.empty();
  Cutout& cutout = cutouts_.emplace_back();
  cutout.cutoff = material.alpha_cutoff;
  cutout.texture = textured ? material.texture : -1;
  for (int k = 0; k < 3; ++k) {
    cutout.texcoord[k] = mesh.texcoords.empty() ? glm::dvec2(0) : glm::dvec2(mesh.texcoords[corner[k]]);
    cutout.alpha[k] = double(material.base_color.a) * (mesh.colors.empty() ? 1.0 : double(mesh.colors[corner[k]].a));
  }
}

glm::dvec4 TriangleSoup::light_to_local(const glm::dvec4& light) const {
  return light.w == 0 ? light : glm::dvec4(to_local(glm::dvec3(light) / light.w), 1);
}

double TriangleSoup::distance(std::uint32_t triangle, const glm::dvec3& origin, const glm::dvec3& direction) const {
  const Triangle& t = triangles_[triangle];
  const glm::dvec3 n = t.normal();
  const double length2 = glm::dot(direction, direction);
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const glm::dvec3& corner : {t.a, t.b, t.c}) {
    const double at = glm::dot(corner - origin, direction) / length2;
    least = std::min(least, at);
    most = std::max(most, at);
  }
  const double slope = glm::dot(n, direction);
  return slope == 0 ? least : std::clamp(glm::dot(n, t.a - origin) / slope, least, most);
}

bool TriangleSoup::separates(std::uint32_t triangle, const glm::dvec3& point, const glm::dvec4& light) const {
  const Triangle& t = triangles_[triangle];
  const glm::dvec3 e1 = t.b - t.a, e2 = t.c - t.a, n = glm::cross(e1, e2), to_light = glm::dvec3(light) - light.w * t.a;
  const double here = glm::dot(n, point - t.a), there = glm::dot(n, to_light);
  if (!(here < 0 ? there > 0 : there < 0)) return false;
  // The cross product of a sliver is only as good as its sides are long.
  const double slack = rounding_ * glm::length(e1) * glm::length(e2);
  return std::abs(here) > slack && std::abs(there) > slack * (light.w + glm::length(to_light));
}

bool TriangleSoup::hole(std::uint32_t triangle, const glm::dvec3& origin, const glm::dvec3& direction) const {
  if (!has_holes() || cutout_of_[triangle] < 0) return false;
  const Cutout& cutout = cutouts_[std::size_t(cutout_of_[triangle])];
  const glm::dvec2 w = weights(triangles_[triangle], origin + distance(triangle, origin, direction) * direction);
  const double v = std::clamp(w.x, 0.0, 1.0), u = std::clamp(w.y, 0.0, 1.0 - v);
  const auto between = [&](const auto& of) { return of[0] + v * (of[1] - of[0]) + u * (of[2] - of[0]); };
  double alpha = between(cutout.alpha);
  const glm::dvec2 at = between(cutout.texcoord);
  if (cutout.texture >= 0 && std::isfinite(at.x) && std::isfinite(at.y))
    alpha *= sample_alpha(textures_[std::size_t(cutout.texture)], at);
  return alpha < cutout.cutoff;
}

}  // namespace psm
