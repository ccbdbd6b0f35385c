// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/sketch.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace psm {

double Limits::fade(const glm::dvec3& p) const {
  double fade = 1.0;
  for (int i = 0; i < 3; ++i) {
    const double below = outer.min[i] < inner.min[i] ? (p[i] - outer.min[i]) / (inner.min[i] - outer.min[i]) : 1.0;
    const double above = outer.max[i] > inner.max[i] ? (outer.max[i] - p[i]) / (outer.max[i] - inner.max[i]) : 1.0;
    fade = std::min({fade, below, above});
  }
  return std::clamp(fade, 0.0, 1.0);
}

void Sketch::line(const glm::dvec3& a, const glm::dvec3& b, const Pen& pen, Head head) {
  list.lines.push_back({at(a), at(b), pen.role, pen.width, pen.style, head == Head::arrow, pen.opacity, pen.opacity});
}

void Sketch::faded_line(const glm::dvec3& a, const glm::dvec3& b, const Pen& pen, Head head) {
  line(a, b, pen, head);
  list.lines.back().fade_a *= limits_.fade(a);
  list.lines.back().fade_b *= limits_.fade(b);
}

void Sketch::piece(const Piece& p, const Pen& pen, Head head) {
  const auto inside = clip_segment(at(p.a), at(p.b), limits_.inner);
  if (!inside) {
    // Along a segment outside, the fade has its maximum somewhere between: two halves follow it well enough.
    const glm::dvec3 middle = 0.5 * (p.a + p.b);
    faded_line(p.a, middle, pen, Head::none);
    faded_line(middle, p.b, pen, head);
    return;
  }
  if (inside->cut_a) faded_line(p.a, inside->a, pen, Head::none);
  line(inside->a, inside->b, pen, inside->cut_b ? Head::none : head);
  if (inside->cut_b) faded_line(inside->b, p.b, pen, head);
}

void Sketch::line_through(const glm::dvec4& a, const glm::dvec4& b, const Pen& pen) {
  for (const Piece& p : split_segment(a, b, limits_.outer)) piece(p, pen);
}

void Sketch::line_in_front(const glm::dvec4& a, const glm::dvec4& b, const Pen& pen) {
  if (const auto p = clip_segment(a, b, limits_.outer)) piece(*p, pen);
}

void Sketch::fill(const std::vector<glm::dvec4>& corners, Role role, double alpha, Sides sides) {
  for (int side : {1, -1}) {
    if (side < 0 && sides == Sides::front) break;
    DrawFill fill{{}, role, alpha};
    for (const glm::dvec3& p : clip_polygon(corners, limits_.inner, side)) fill.corners.push_back(at(p));
    if (!fill.corners.empty()) list.fills.push_back(std::move(fill));
  }
}

void Sketch::body(const ConvexBody& body, const glm::dmat4& map, double alpha, const Pen& edges) {
  std::vector<glm::dvec4> mapped;
  for (const glm::dvec3& v : body.vertices) mapped.push_back(map * at(v));
  for (const std::vector<int>& facet : body.facets) {
    std::vector<glm::dvec4> corners;
    for (int i : facet) corners.push_back(mapped[i]);
    if (alpha > 0.0) fill(corners, edges.role, alpha);
  }
  for (const auto& [i, j] : body_edges(body)) line_through(mapped[i], mapped[j], edges);
}

void Sketch::label(const glm::dvec3& anchor, std::string text, Role role, int priority) {
  list.labels.push_back({at(anchor), std::move(text), role, priority});
}

void append(DrawList& list, DrawList other) {
  std::move(other.lines.begin(), other.lines.end(), std::back_inserter(list.lines));
  std::move(other.fills.begin(), other.fills.end(), std::back_inserter(list.fills));
  std::move(other.points.begin(), other.points.end(), std::back_inserter(list.points));
  std::move(other.labels.begin(), other.labels.end(), std::back_inserter(list.labels));
  std::move(other.texts.begin(), other.texts.end(), std::back_inserter(list.texts));
}

void remove(DrawList& list, const std::vector<Role>& roles) {
  const auto has_role = [&](const auto& thing) { return std::find(roles.begin(), roles.end(), thing.role) != roles.end(); };
  std::erase_if(list.lines, has_role);
  std::erase_if(list.fills, has_role);
  std::erase_if(list.points, has_role);
  std::erase_if(list.labels, has_role);
  std::erase_if(list.texts, has_role);
}

std::vector<std::array<int, 2>> body_edges(const ConvexBody& body) {
  std::set<std::array<int, 2>> edges;
  for (const std::vector<int>& facet : body.facets) {
    for (std::size_t k = 0; k < facet.size(); ++k) {
      const int i = facet[k], j = facet[(k + 1) % facet.size()];
      if (i != j) edges.insert({std::min(i, j), std::max(i, j)});
    }
  }
  return {edges.begin(), edges.end()};
}

const std::array<std::array<int, 2>, 12>& box_edges() {
  static constexpr std::array<std::array<int, 2>, 12> edges{
      {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
  return edges;
}

std::array<glm::dvec3, 8> cube_corners() {
  std::array<glm::dvec3, 8> corners;
  for (int i = 0; i < 8; ++i) corners[i] = {i % 4 == 1 || i % 4 == 2 ? 1.0 : -1.0, i % 4 >= 2 ? 1.0 : -1.0, i < 4 ? -1.0 : 1.0};
  return corners;
}

}  // namespace psm
