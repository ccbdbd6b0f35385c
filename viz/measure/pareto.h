// SPDX-License-Identifier: GPL-3.0-or-later
// The runs that no other run beats in both cost and error.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace psm {

/// Indices into (cost, error), by growing cost: no other point is at most as large in both and smaller in one. Of equal points
/// all are there. Points that are not finite are never there.
std::vector<std::size_t> pareto_front(std::span<const glm::dvec2> points);

}  // namespace psm
