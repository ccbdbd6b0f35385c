// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "scene/analysis.h"
#include "scene/json_node.h"

namespace psm {
namespace {

const char* name_of(PostLight post) {
  switch (post) {
    case PostLight::directional:
      return "directional";
    case PostLight::point:
      return "point";
    case PostLight::inverted_point:
      return "inverted_point";
  }
  return "";
}

JsonNode light_case_node(const LightCase& light) {
  JsonNode node = JsonNode::object();
  node["world"] = psm::name_of(light.world);
  node["post"] = name_of(light.post);
  node["w"] = light.w;
  node["light_post"] = light.light_post;
  node["naive_order"] = light.reversed_order ? "reversed" : "same";
  node["inside_receivers"] = JsonNode::boolean(light.inside_receivers);
  node["inside_frustum"] = JsonNode::boolean(light.inside_frustum);
  node["kappa"] = light.kappa;
  node["within_half_texel"] = JsonNode::boolean(light.within_half_texel);
  return node;
}

JsonNode scene_node(const Scene& scene) {
  JsonNode node = JsonNode::object();
  node["id"] = scene.id;
  node["triangles"] = JsonNode::integer((long long)scene.triangle_count());
  node["bounds_min"] = scene.bounds.empty() ? JsonNode() : JsonNode(scene.bounds.min);
  node["bounds_max"] = scene.bounds.empty() ? JsonNode() : JsonNode(scene.bounds.max);
  return node;
}

JsonNode scene_body_node(const Analysis& analysis) {
  const ConvexBody& body = analysis.scene_body;
  JsonNode node = JsonNode::object();
  node["grain"] = analysis.scene_body_used == SceneBody::hull ? "hull" : "box";
  node["facets"] = JsonNode::integer((long long)body.facets.size());
  node["volume"] = body.volume();
  return node;
}

/// Four rows of four.
JsonNode matrix_node(const glm::dmat4& matrix) {
  const glm::dmat4 rows = glm::transpose(matrix);
  JsonNode node = JsonNode::array();
  for (int i = 0; i < 4; ++i) node.push_back(rows[i]);
  return node;
}

JsonNode matrices_node(const Analysis& analysis) {
  JsonNode node = JsonNode::object();
  node["view_from_world"] = matrix_node(analysis.view_from_world);
  node["clip_from_view"] = matrix_node(analysis.clip_from_view);
  node["map_from_world"] = analysis.map_from_world ? matrix_node(*analysis.map_from_world) : JsonNode();
  node["map_beyond_from_world"] = analysis.map_beyond_from_world ? matrix_node(*analysis.map_beyond_from_world) : JsonNode();
  JsonNode& cube = node["cube_maps_from_world"];
  if (!analysis.cube_maps_from_world) return node;
  cube = JsonNode::array();
  for (const glm::dmat4& matrix : *analysis.cube_maps_from_world) cube.push_back(matrix_node(matrix));
  return node;
}

JsonNode body_node(const ConvexBody& body) {
  JsonNode vertices = JsonNode::array(), facets = JsonNode::array();
  for (const glm::dvec3& vertex : body.vertices) vertices.push_back(vertex);
  for (const std::vector<int>& corners : body.facets) {
    JsonNode facet = JsonNode::array();
    for (const int corner : corners) facet.push_back(JsonNode::integer(corner));
    facets.push_back(std::move(facet));
  }
  JsonNode node = JsonNode::object();
  node["vertices"] = std::move(vertices);
  node["facets"] = std::move(facets);
  node["volume"] = body.empty() ? 0.0 : body.volume();
  return node;
}

JsonNode texels_node(const std::optional<TexelStatistics>& texels) {
  if (!texels) return JsonNode();
  JsonNode node = JsonNode::object();
  node["m_mean"] = texels->m_mean;
  node["m_p50"] = texels->m_p50;
  node["m_p95"] = texels->m_p95;
  node["m_max"] = texels->m_max;
  node["undersampled_fraction"] = texels->undersampled_fraction;
  return node;
}

JsonNode error_node(const std::optional<ModelError>& error, const std::optional<TexelStatistics>& texels) {
  JsonNode node = JsonNode::object();
  const auto member = [&](const char* name, double ModelError::*value) {
    node[name] = error ? JsonNode((*error).*value) : JsonNode();
  };
  member("F_near", &ModelError::F_near);
  member("F_far", &ModelError::F_far);
  member("F_max", &ModelError::F_max);
  member("E_max_line", &ModelError::E_max_line);
  member("E_max_frustum", &ModelError::E_max_frustum);
  member("storage_factor", &ModelError::storage_factor);
  node["texels"] = texels_node(texels);
  return node;
}

JsonNode notes_node(const std::vector<Note>& notes) {
  JsonNode list = JsonNode::array();
  for (const Note& note : notes) {
    JsonNode node = JsonNode::object();
    node["code"] = note.code;
    node["text"] = note.text;
    node["value"] = note.value;
    node["limit"] = note.limit;
    list.push_back(std::move(node));
  }
  return list;
}

JsonNode degrees(const std::optional<double>& radians) {
  return radians ? JsonNode(*radians * (180.0 / 3.14159265358979323846)) : JsonNode();
}

/// A quantity that came out as no number is null; its note says so, so that it is never mistaken for one that does not exist.
void add_nan_notes(const std::vector<std::string>& paths, std::vector<Note>& notes) {
  for (const std::string& path : paths)
    notes.push_back({"not_a_number", path + " could not be computed in doubles and is null.", std::nullopt, std::nullopt});
}

}  // namespace

std::string analysis_to_json(const Analysis& analysis, const Scene& scene) {
  std::vector<Note> notes = analysis.notes;
  JsonNode root = JsonNode::object();
  root["psmlab"] = JsonNode::integer(1);
  root["experiment"] = experiment_node(analysis.experiment);
  root["light_case"] = light_case_node(analysis.light_case);
  root["scene"] = scene_node(scene);
  root["theta_deg"] = degrees(analysis.theta);
  root["phi_deg"] = degrees(analysis.phi);
  root["n"] = analysis.near;
  root["f"] = analysis.far;
  root["rho"] = analysis.rho;
  root["lambda"] = analysis.lambda;
  root["camera_shift"] = analysis.camera_shift;
  root["technique_used"] = psm::name_of(analysis.technique_used);
  root["worse_than_uniform"] = JsonNode::boolean(analysis.worse_than_uniform);
  root["notes"] = JsonNode();  // its place; the notes are complete once all else is there
  root["matrices"] = matrices_node(analysis);
  root["reversed_depth"] = JsonNode::boolean(analysis.reversed_depth);
  root["vanishing_plane"] = analysis.vanishing_plane ? JsonNode(*analysis.vanishing_plane) : JsonNode();
  root["scene_body"] = scene_body_node(analysis);
  root["caster_body"] = body_node(analysis.caster_body);
  root["receivers_body"] = body_node(analysis.receivers_body);
  root["error"] = error_node(analysis.model_error, analysis.texels);
  add_nan_notes(root.nan_paths(), notes);
  root["notes"] = notes_node(notes);
  return root.to_text() + "\n";
}

}  // namespace psm
