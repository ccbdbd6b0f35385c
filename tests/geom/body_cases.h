// SPDX-License-Identifier: GPL-3.0-or-later
// Cameras, scene boxes and lights whose bodies are hard, and random ones: for tests and for the benchmark.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geom/convex_body.h"
#include "geom/frustum.h"

namespace psm {

struct BodyCase {
  std::string name;
  ViewFrame view;
  double near = 1, far = 100;
  glm::dvec3 min{0}, max{0};  // S
  glm::dvec4 light{0};
  std::optional<ViewFrame> spot = {};  // its pyramid is L
};

/// The planes of the bodies of a case.
struct CasePlanes {
  ConvexBody scene;                  // S
  std::vector<Plane> frustum, spot;  // V, L
  std::vector<Plane> caster;         // hull(V + l), then L
};
CasePlanes planes_of(const BodyCase& c);

ConvexBody receivers_of(const CasePlanes& p);                             // R = V ∩ S ∩ L
ConvexBody caster_body_of(const CasePlanes& p);                           // H = hull(V + l) ∩ S ∩ L
ConvexBody lit_casters_of(const CasePlanes& p, const glm::dvec4& light);  // H_R = hull(R + l) ∩ S ∩ L

std::vector<BodyCase> random_cases(int count, unsigned seed);
std::vector<BodyCase> degenerate_cases();  // 60

}  // namespace psm
