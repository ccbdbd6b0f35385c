// SPDX-License-Identifier: GPL-3.0-or-later
#include "double_clipper.h"

#include <algorithm>
#include <cmath>

#include "ways.h"

namespace psm {

DoubleClipper::DoubleClipper(const glm::dvec3& min, const glm::dvec3& max) : vertex_count(8), facet_count(6) {
  static constexpr std::uint8_t box[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (int i = 0; i < 8; ++i) vertices[i] = {i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z};
  for (int f = 0; f < 6; ++f) {
    facets[f].size = 4;
    std::copy(box[f], box[f] + 4, facets[f].corner);
  }
  tolerance_ = 1e-12 * glm::length(max - min);
}

int DoubleClipper::crossing(int a, int b) {
  if (value_[a] == 0) return a;
  if (value_[b] == 0) return b;
  if (a > b) std::swap(a, b);
  for (int i = 0; i < crossing_count_; ++i)
    if (crossings_[i].a == a && crossings_[i].b == b) return crossings_[i].made;
  vertices[vertex_count] = vertices[a] + (vertices[b] - vertices[a]) * (value_[a] / (value_[a] - value_[b]));
  crossings_[crossing_count_++] = {std::uint8_t(a), std::uint8_t(b), std::uint8_t(vertex_count)};
  return vertex_count++;
}

void DoubleClipper::cut_facet(const Facet& facet, Facet& out) {
  out.size = 0;
  const auto push = [&](int v) {
    if (out.size == 0 || out.corner[out.size - 1] != v) out.corner[out.size++] = std::uint8_t(v);
  };
  int leave = -1, enter = -1;
  for (int k = 0; k < facet.size; ++k) {
    const int a = facet.corner[k], b = facet.corner[k + 1 < facet.size ? k + 1 : 0];
    if (value_[a] >= 0) push(a);
    if ((value_[a] < 0) == (value_[b] < 0)) continue;
    const int made = crossing(a, b);
    (value_[a] < 0 ? enter : leave) = made;
    push(made);
  }
  if (out.size > 1 && out.corner[0] == out.corner[out.size - 1]) --out.size;
  if (leave == enter) return;
  next_[enter] = std::int16_t(leave);
  cap_start_ = enter;
  ++cap_edges_;
}

void DoubleClipper::add_cap() {
  if (cap_edges_ < 3) return;
  Facet cap;
  int at = cap_start_;
  do {
    cap.corner[cap.size++] = std::uint8_t(at);
    at = next_[at];
  } while (at >= 0 && at != cap_start_ && cap.size < kMaxCorners);
  if (cap.size >= 3 && facet_count < kMaxFacets) facets[facet_count++] = cap;
}

void DoubleClipper::cut(const glm::dvec4& plane) {
  const double tolerance = tolerance_ * glm::length(glm::dvec3(plane));
  bool any_outside = false, any_inside = false;
  for (int i = 0; i < vertex_count; ++i) {
    double v = glm::dot(glm::dvec3(plane), vertices[i]) + plane.w;
    if (std::abs(v) <= tolerance) v = 0;
    value_[i] = v;
    (v < 0 ? any_outside : any_inside) = true;
  }
  if (!any_outside) return;
  if (!any_inside) {
    vertex_count = facet_count = 0;
    return;
  }
  crossing_count_ = cap_edges_ = 0;
  std::fill(next_, next_ + kMaxVertices, std::int16_t(-1));
  int kept = 0;
  for (int f = 0; f < facet_count; ++f) {
    Facet out;
    cut_facet(facets[f], out);
    if (out.size >= 3) facets[kept++] = out;
  }
  facet_count = kept;
  add_cap();
  int renamed[kMaxVertices];
  std::fill(renamed, renamed + vertex_count, -1);
  for (int f = 0; f < facet_count; ++f)
    for (int k = 0; k < facets[f].size; ++k) renamed[facets[f].corner[k]] = 0;
  int used = 0;
  for (int i = 0; i < vertex_count; ++i)
    if (renamed[i] == 0) {
      vertices[used] = vertices[i];
      renamed[i] = used++;
    }
  vertex_count = used;
  for (int f = 0; f < facet_count; ++f)
    for (int k = 0; k < facets[f].size; ++k) facets[f].corner[k] = std::uint8_t(renamed[facets[f].corner[k]]);
}

namespace {

/// Frustum planes and silhouettes as plain doubles.
int caster_planes(const BodyCase& c, glm::dvec4* out) {
  const ViewFrame& v = c.view;
  const bool bounded = !std::isinf(c.far);
  const auto through = [](const glm::dvec3& n, const glm::dvec3& p) { return glm::dvec4(n, -glm::dot(n, p)); };
  const auto sides = [&](const ViewFrame& f, glm::dvec4* p) {
    p[0] = through(f.tan_x * f.forward + f.right, f.eye);
    p[1] = through(f.tan_x * f.forward - f.right, f.eye);
    p[2] = through(f.tan_y * f.forward + f.up, f.eye);
    p[3] = through(f.tan_y * f.forward - f.up, f.eye);
  };
  glm::dvec4 p[6];
  sides(v, p);
  p[4] = through(v.forward, v.eye + c.near * v.forward);
  p[5] = bounded ? through(-v.forward, v.eye + c.far * v.forward) : glm::dvec4(0, 0, 0, 1);
  double value[6];
  int n = 0;
  for (int i = 0; i < 6; ++i) {
    value[i] = glm::dot(p[i], c.light);
    if (value[i] >= 0 && (i < 5 || bounded)) out[n++] = p[i];
  }
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      if (i / 2 != j / 2 && value[i] > 0 && value[j] < 0) out[n++] = value[i] * p[j] - value[j] * p[i];
  if (c.spot) {
    sides(*c.spot, out + n);
    out[n + 4] = through(c.spot->forward, c.spot->eye);
    n += 5;
  }
  return n;
}

}  // namespace

WayBody way_double_clipper(const BodyCase& c) {
  glm::dvec4 planes[32];
  const int count = caster_planes(c, planes);
  DoubleClipper clipper(c.min, c.max);
  for (int i = 0; i < count; ++i) clipper.cut(planes[i]);
  WayBody out;
  out.vertices.assign(clipper.vertices, clipper.vertices + clipper.vertex_count);
  for (int f = 0; f < clipper.facet_count; ++f) {
    const auto& facet = clipper.facets[f];
    out.facet_sizes.push_back(facet.size);
    for (int k = 1; k + 1 < facet.size; ++k) {
      const glm::dvec3 o = out.vertices[0], a = out.vertices[facet.corner[0]] - o, b = out.vertices[facet.corner[k]] - o;
      out.volume += glm::dot(a, glm::cross(b, out.vertices[facet.corner[k + 1]] - o)) / 6;
    }
  }
  return out;
}

}  // namespace psm
