// SPDX-License-Identifier: GPL-3.0-or-later
// A tight clipper in doubles, as one would write it without exactness: fixed arrays, vertices interpolated along edges, a
// tolerance relative to the box's size.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace psm {

class DoubleClipper {
 public:
  static constexpr int kMaxVertices = 128, kMaxFacets = 40, kMaxCorners = 32;

  DoubleClipper(const glm::dvec3& min, const glm::dvec3& max);
  void cut(const glm::dvec4& plane);

  struct Facet {
    int size = 0;
    std::uint8_t corner[kMaxCorners];
  };
  int vertex_count = 0, facet_count = 0;
  glm::dvec3 vertices[kMaxVertices];
  Facet facets[kMaxFacets];

 private:
  int crossing(int a, int b);
  void cut_facet(const Facet& facet, Facet& out);
  void add_cap();

  double tolerance_ = 0;
  double value_[kMaxVertices];
  struct Crossing {
    std::uint8_t a, b, made;
  };
  Crossing crossings_[kMaxCorners];
  int crossing_count_ = 0;
  std::int16_t next_[kMaxVertices];  // the cap's edges
  int cap_start_ = -1, cap_edges_ = 0;
};

}  // namespace psm
