// SPDX-License-Identifier: GPL-3.0-or-later
// The camera and the light that a file brings along.
#include <tiny_gltf.h>

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scene/gltf_reader.h"

namespace psm::gltf {
namespace {

/// A node's place and its unit axes; cameras and lights look along -z and ignore scale.
struct Frame {
  glm::dvec3 position, right, up, backward;
};

std::optional<glm::dvec3> unit(const glm::dvec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0.0)) return std::nullopt;
  return glm::normalize(v / largest);
}

/// None where the node's transformation leaves no direction.
std::optional<Frame> frame_of(const glm::dmat4& world_from_node) {
  const auto backward = unit(glm::dvec3(world_from_node[2])), y = unit(glm::dvec3(world_from_node[1]));
  if (!backward || !y) return std::nullopt;
  const auto right = unit(glm::cross(*y, *backward));
  if (!right) return std::nullopt;
  return Frame{glm::dvec3(world_from_node[3]), *right, glm::cross(*backward, *right), *backward};
}

/// How far along its view a camera or spot light aims: at the depth of the scene's middle, or, where that lies behind it, a
/// scene's radius away.
double aim_distance(const Frame& frame, const Bounds& bounds) {
  const glm::dvec3 center = 0.5 * bounds.min + 0.5 * bounds.max;
  const double radius = 0.5 * glm::length(bounds.max - bounds.min);
  const double depth = glm::dot(center - frame.position, -frame.backward);
  const double least = radius > 0.0 ? radius : std::max(glm::length(frame.position), 1.0);
  return depth > 0.01 * least ? depth : least;
}

/// Most cameras stand upright; (0, 1, 0) then says the same as their own up, and is what people read.
glm::dvec3 readable_up(const Frame& frame) {
  const bool upright = std::abs(frame.right.y) < 1e-6 && frame.up.y > 1e-3;
  return upright ? glm::dvec3(0.0, 1.0, 0.0) : frame.up;
}

CameraSettings camera_settings(const tinygltf::PerspectiveCamera& view, const Frame& frame, const Bounds& bounds) {
  CameraSettings camera;
  camera.position = frame.position;
  camera.target = frame.position - aim_distance(frame, bounds) * frame.backward;
  camera.up = readable_up(frame);
  camera.vertical_fov_deg = glm::degrees(view.yfov);
  camera.near = view.znear;
  camera.far = view.zfar > 0.0 ? view.zfar : std::numeric_limits<double>::infinity();
  return camera;
}

/// Full apex angle; experiments allow less than a half space.
double cone_deg(const tinygltf::Light& light, Notes& notes) {
  const double apex = 2.0 * glm::degrees(light.spot.outerConeAngle);
  if (apex < 180.0 - 1e-6) return apex;
  notes.add("gltf_spot_cone", "The spot light's cone is a half space; it is narrowed to 179 degrees.");
  return 179.0;
}

LightSettings light_settings(const tinygltf::Light& light, const Frame& frame, const Bounds& bounds, Notes& notes) {
  LightSettings settings;
  if (light.type == "directional") {
    settings.type = LightType::directional;
    settings.to_light = frame.backward;
    return settings;
  }
  settings.type = light.type == "spot" ? LightType::spot : LightType::point;
  settings.position = frame.position;
  if (settings.type == LightType::point) return settings;
  settings.target = frame.position - aim_distance(frame, bounds) * frame.backward;
  settings.cone_deg = cone_deg(light, notes);
  return settings;
}

int light_of(const tinygltf::Node& node) {
  const auto extension = node.extensions.find("KHR_lights_punctual");
  return extension == node.extensions.end() ? -1 : extension->second.Get("light").GetNumberAsInt();
}

/// Frames of the nodes that hold something; those that have no direction are left out with a note.
std::optional<Frame> usable_frame(Source& source, const NodeGraph& graph, int node) {
  auto frame = frame_of(graph.world_from_node[std::size_t(node)]);
  if (!frame)
    source.notes.add("gltf_frame",
                     at("nodes", std::size_t(node)) + " holds a camera or light, but its transformation leaves no direction.");
  return frame;
}

void read_camera(Source& source, const NodeGraph& graph, Scene& scene) {
  int found = 0, flat = 0;
  for (const int node : graph.order) {
    const int index = source.model.nodes[std::size_t(node)].camera;
    if (index < 0) continue;
    const auto& camera = source.model.cameras[std::size_t(index)];
    flat += camera.type != "perspective";
    if (camera.type != "perspective") continue;
    const auto frame = usable_frame(source, graph, node);
    if (frame && found++ == 0) scene.camera = camera_settings(camera.perspective, *frame, scene.bounds);
  }
  if (found > 1) source.notes.add("gltf_camera", "The first of " + std::to_string(found) + " cameras is used.");
  if (flat) source.notes.add("gltf_orthographic", "Orthographic cameras are left out: only perspective ones are used.");
}

void read_light(Source& source, const NodeGraph& graph, Scene& scene) {
  int found = 0;
  for (const int node : graph.order) {
    const int index = light_of(source.model.nodes[std::size_t(node)]);
    if (index < 0) continue;
    const auto frame = usable_frame(source, graph, node);
    if (frame && found++ == 0)
      scene.light = light_settings(source.model.lights[std::size_t(index)], *frame, scene.bounds, source.notes);
  }
  if (found > 1) source.notes.add("gltf_light", "The first of " + std::to_string(found) + " lights is used.");
}

}  // namespace

void read_camera_and_light(Source& source, const NodeGraph& graph, Scene& scene) {
  read_camera(source, graph, scene);
  read_light(source, graph, scene);
}

}  // namespace psm::gltf
