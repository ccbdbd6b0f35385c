// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/matrix_text.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "scene/json_node.h"

namespace psm {
namespace {

constexpr std::array kLanguages{"glsl", "cpp", "json"};                  // by MatrixLanguage
constexpr std::array kConventions{"opengl", "d3d", "reversed_z"};        // by ClipConvention
constexpr std::array kRanges{"[-1, 1]", "[0, 1]", "[0, 1], near at 1"};  // of z / w

template <class Enum, std::size_t N>
std::optional<Enum> from_name(const std::array<const char*, N>& names, const std::string& name) {
  for (std::size_t i = 0; i < N; ++i)
    if (name == names[i]) return Enum(i);
  return std::nullopt;
}

struct NamedMatrix {
  std::string name, meaning;
  glm::dmat4 value;
};

std::vector<NamedMatrix> matrices_of(const Analysis& a, ClipConvention convention) {
  std::vector<NamedMatrix> out{{"view_from_world", "the eye's coordinates: x right, y up, looking along -z", a.view_from_world},
                               {"clip_from_view", "the eye's projection", eye_projection(a, convention)}};
  const auto add_map = [&](const std::string& name, const std::string& meaning, const glm::dmat4& map) {
    out.push_back({name, meaning, in_convention(map, convention)});
  };
  if (a.map_from_world) add_map("map_from_world", "the shadow map; depth grows away from the light", *a.map_from_world);
  if (a.map_beyond_from_world)
    add_map("map_beyond_from_world", "the second map, of what is behind the eye; lit is what both maps light",
            *a.map_beyond_from_world);
  if (a.cube_maps_from_world)
    for (int i = 0; i < 6; ++i)
      add_map("cube_map_" + std::to_string(i) + "_from_world", std::string("the map towards ") + "+-"[i % 2] + "xyz"[i / 2],
              (*a.cube_maps_from_world)[std::size_t(i)]);
  return out;
}

/// A literal is a real number in both languages only with a point or an exponent.
std::string literal(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value == 0.0 ? 0.0 : value);
  const std::string number = text;
  return number.find_first_of(".e") == std::string::npos ? number + ".0" : number;
}

/// Constructors of both languages take columns.
std::string constructor(const NamedMatrix& matrix, const std::string& type, int digits) {
  std::string text = "// " + matrix.meaning + "\nconst " + type + " " + matrix.name + "(\n";
  if (type == "mat4") text = "// " + matrix.meaning + "\nconst mat4 " + matrix.name + " = mat4(\n";
  for (int column = 0; column < 4; ++column) {
    text += "    ";
    for (int row = 0; row < 4; ++row) {
      const double value = matrix.value[column][row];
      text += literal(type == "mat4" ? double(float(value)) : value, digits) + (column * row == 9 ? ");" : ",");
      text += row < 3 ? " " : "\n";
    }
  }
  return text;
}

std::string source_code(const std::vector<NamedMatrix>& matrices, MatrixLanguage language, ClipConvention convention) {
  std::string text = std::string("// Clip space: ") + kConventions[std::size_t(convention)] + ", z / w in " +
                     kRanges[std::size_t(convention)] +
                     ". Column vectors: clip_from_view * view_from_world * vec4(position, 1).\n"
                     "// A point's place on the map: p = map_from_world * vec4(position, 1); p.xy / p.w * 0.5 + 0.5.\n";
  for (const NamedMatrix& matrix : matrices)
    text += language == MatrixLanguage::glsl ? constructor(matrix, "mat4", 9) : constructor(matrix, "glm::dmat4", 17);
  return text;
}

std::string json_text(const std::vector<NamedMatrix>& matrices, ClipConvention convention) {
  JsonNode node = JsonNode::object();
  node["convention"] = kConventions[std::size_t(convention)];
  for (const NamedMatrix& matrix : matrices) {
    const glm::dmat4 rows = glm::transpose(matrix.value);
    node[matrix.name] = JsonNode::array();
    for (int i = 0; i < 4; ++i) node[matrix.name].push_back(rows[i]);
  }
  return node.to_text() + "\n";
}

void set_depth_row(glm::dmat4& matrix, const glm::dvec4& row) {
  for (int column = 0; column < 4; ++column) matrix[column].z = row[column];
}

}  // namespace

const char* name_of(MatrixLanguage language) { return kLanguages[std::size_t(language)]; }
const char* name_of(ClipConvention convention) { return kConventions[std::size_t(convention)]; }

std::optional<MatrixLanguage> matrix_language_from_name(const std::string& name) {
  return from_name<MatrixLanguage>(kLanguages, name);
}
std::optional<ClipConvention> clip_convention_from_name(const std::string& name) {
  return from_name<ClipConvention>(kConventions, name);
}

glm::dmat4 in_convention(const glm::dmat4& clip_from_space, ClipConvention convention) {
  if (convention == ClipConvention::opengl) return clip_from_space;
  const glm::dmat4 rows = glm::transpose(clip_from_space);
  glm::dmat4 out = clip_from_space;
  set_depth_row(out, 0.5 * (convention == ClipConvention::d3d ? rows[3] + rows[2] : rows[3] - rows[2]));
  return out;
}

glm::dmat4 eye_projection(const Analysis& analysis, ClipConvention convention) {
  if (convention == ClipConvention::opengl) return analysis.clip_from_view;
  const double n = analysis.experiment.camera.near, r = n / analysis.experiment.camera.far;  // r = 0: far is infinite
  glm::dmat4 out = analysis.clip_from_view;
  if (convention == ClipConvention::d3d)
    set_depth_row(out, {0.0, 0.0, -1.0 / (1.0 - r), -n / (1.0 - r)});
  else
    set_depth_row(out, {0.0, 0.0, r / (1.0 - r), n / (1.0 - r)});
  return out;
}

std::string matrices_text(const Analysis& analysis, MatrixLanguage language, ClipConvention convention) {
  const std::vector<NamedMatrix> matrices = matrices_of(analysis, convention);
  return language == MatrixLanguage::json ? json_text(matrices, convention) : source_code(matrices, language, convention);
}

}  // namespace psm
