// SPDX-License-Identifier: GPL-3.0-or-later
// The node hierarchy. Files may nest nodes as deeply as they are long, so that everything here iterates.
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "scene/gltf_reader.h"

namespace psm::gltf {
namespace {

glm::dvec3 vec3_or(const std::vector<double>& v, double otherwise) {
  return v.size() == 3 ? glm::dvec3(v[0], v[1], v[2]) : glm::dvec3(otherwise);
}

glm::dmat4 rotation_of(const tinygltf::Node& node, const std::string& place) {
  if (node.rotation.size() != 4) return glm::dmat4(1.0);
  const auto& r = node.rotation;
  const double largest = std::max({std::abs(r[0]), std::abs(r[1]), std::abs(r[2]), std::abs(r[3])});
  if (!(largest > 0.0)) fail(place + ".rotation", "is zero; a unit quaternion is needed");
  return glm::mat4_cast(glm::normalize(glm::dquat(r[3] / largest, r[0] / largest, r[1] / largest, r[2] / largest)));
}

/// Exporters round: the fourth row may be off by a float's error.
glm::dmat4 affine(glm::dmat4 matrix, const std::string& place) {
  for (int i = 0; i < 4; ++i) {
    const double expected = i == 3 ? 1.0 : 0.0;
    if (std::abs(matrix[i][3] - expected) > 1e-6) fail(place, "has a fourth row other than 0, 0, 0, 1");
    matrix[i][3] = expected;
  }
  return matrix;
}

glm::dmat4 parent_from_node(const tinygltf::Node& node, const std::string& place) {
  glm::dmat4 matrix(1.0);
  if (node.matrix.size() == 16) {
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = node.matrix[std::size_t(i)];
    return affine(matrix, place + ".matrix");
  }
  matrix = rotation_of(node, place);
  const glm::dvec3 scale = vec3_or(node.scale, 1.0);
  for (int i = 0; i < 3; ++i) matrix[i] *= scale[i];
  matrix[3] = glm::dvec4(vec3_or(node.translation, 0.0), 1.0);
  return matrix;
}

void require_reach(const glm::dmat4& matrix, const std::string& place) {
  for (int i = 0; i < 4; ++i)
    if (!within_reach(glm::dvec3(matrix[i]))) fail(place, "has a transformation beyond 1e30, or none that is a number");
}

/// -1 for roots.
std::vector<int> parents_of(const tinygltf::Model& model) {
  std::vector<int> parents(model.nodes.size(), -1);
  for (std::size_t i = 0; i < model.nodes.size(); ++i)
    for (const int child : model.nodes[i].children) {
      int& parent = parents[std::size_t(child)];
      if (parent >= 0)
        fail(at("nodes", std::size_t(child)), "is a child of " + at("nodes", std::size_t(parent)) + " and of " + at("nodes", i) +
                                                  "; a node has one parent at most, once");
      parent = int(i);
    }
  return parents;
}

/// Depth first, parents before children, children in file order; nodes already in `seen` are left out.
std::vector<int> depth_first(const tinygltf::Model& model, const std::vector<int>& roots, std::vector<bool>& seen) {
  std::vector<int> order, stack(roots.rbegin(), roots.rend());
  while (!stack.empty()) {
    const int node = stack.back();
    stack.pop_back();
    if (seen[std::size_t(node)]) continue;
    seen[std::size_t(node)] = true;
    order.push_back(node);
    const auto& children = model.nodes[std::size_t(node)].children;
    stack.insert(stack.end(), children.rbegin(), children.rend());
  }
  return order;
}

std::vector<int> all_roots(const std::vector<int>& parents) {
  std::vector<int> roots;
  for (std::size_t i = 0; i < parents.size(); ++i)
    if (parents[i] < 0) roots.push_back(int(i));
  return roots;
}

std::vector<int> shown_roots(const tinygltf::Model& model, const std::vector<int>& parents) {
  if (model.scenes.empty()) return all_roots(parents);
  return model.scenes[model.defaultScene >= 0 ? std::size_t(model.defaultScene) : 0].nodes;
}

}  // namespace

bool within_reach(const glm::dvec3& p) {
  return std::abs(p.x) <= kLargestCoordinate && std::abs(p.y) <= kLargestCoordinate && std::abs(p.z) <= kLargestCoordinate;
}

NodeGraph walk_nodes(const tinygltf::Model& model) {
  const std::vector<int> parents = parents_of(model);
  NodeGraph graph;
  graph.world_from_node.assign(model.nodes.size(), glm::dmat4(1.0));

  std::vector<bool> seen(model.nodes.size(), false);
  for (const int node : depth_first(model, all_roots(parents), seen)) {
    const std::string place = at("nodes", std::size_t(node));
    glm::dmat4& world = graph.world_from_node[std::size_t(node)];
    world = parent_from_node(model.nodes[std::size_t(node)], place);
    if (const int parent = parents[std::size_t(node)]; parent >= 0) world = graph.world_from_node[std::size_t(parent)] * world;
    require_reach(world, place);
  }
  // With one parent at most, whatever no root reaches lies on a cycle or below one.
  for (std::size_t i = 0; i < seen.size(); ++i)
    if (!seen[i])
      fail(at("nodes", i) + ".children", "leads back to the node itself or hangs below such a cycle; nodes form trees");

  std::vector<bool> placed(model.nodes.size(), false);
  graph.order = depth_first(model, shown_roots(model, parents), placed);
  return graph;
}

}  // namespace psm::gltf
