// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/scene_buffers.h"

#include <algorithm>
#include <cstddef>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <utility>

#include "scene/closed_mesh.h"

namespace psm::gl {
namespace {

struct Vertex {
  glm::vec3 position, normal;
  glm::vec2 texcoord;
  glm::vec4 color;
};

using IndexList = std::vector<std::uint32_t>;

/// Meshes of one material become one draw call.
struct Assembly {
  std::vector<Vertex> vertices;
  struct List {
    IndexList indices;
    std::vector<Part> parts;
    bool colored = false;
  };
  std::map<std::pair<Primitive, int>, List> lists;
};

/// (0, 1, 0) for what has no direction: it is lit like the ground.
glm::vec3 unit_or_up(const glm::dvec3& n) {
  const double length = glm::length(n);
  return length > 0.0 ? glm::vec3(n / length) : glm::vec3(0.0f, 1.0f, 0.0f);
}

Vertex vertex_of(const Mesh& mesh, std::uint32_t i, const glm::dvec3& origin, double unit) {
  Vertex v;
  v.position = glm::vec3((mesh.positions[i] - origin) / unit);
  v.normal = mesh.normals.empty() ? glm::vec3(0.0f, 1.0f, 0.0f) : unit_or_up(glm::dvec3(mesh.normals[i]));
  v.texcoord = mesh.texcoords.empty() ? glm::vec2(0.0f) : mesh.texcoords[i];
  v.color = mesh.colors.empty() ? glm::vec4(1.0f) : mesh.colors[i];
  return v;
}

Bounds bounds_of(const Mesh& mesh) {
  Bounds bounds;
  for (const glm::dvec3& p : mesh.positions) bounds.add(p);
  return bounds;
}

void append_indices(IndexList& to, const IndexList& from, std::uint32_t base) {
  to.reserve(to.size() + from.size());
  for (const std::uint32_t i : from) to.push_back(base + i);
}

/// Triangles without normals get their own corners, with the normal of the face.
void append_flat_triangles(Assembly& all, IndexList& list, const Mesh& mesh, const glm::dvec3& origin, double unit) {
  for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3) {
    const std::uint32_t* corner = &mesh.triangles[t];
    const glm::dvec3 a = mesh.positions[corner[0]], b = mesh.positions[corner[1]], c = mesh.positions[corner[2]];
    const glm::vec3 normal = unit_or_up(glm::cross((b - a) / unit, (c - a) / unit));
    for (int k = 0; k < 3; ++k) {
      list.push_back(std::uint32_t(all.vertices.size()));
      all.vertices.push_back(vertex_of(mesh, corner[k], origin, unit));
      all.vertices.back().normal = normal;
    }
  }
}

void append_mesh(Assembly& all, const Mesh& mesh, const glm::dvec3& origin, double unit) {
  const bool flat = mesh.normals.empty() && !mesh.triangles.empty();
  const std::uint32_t base = std::uint32_t(all.vertices.size());
  if (!flat || !mesh.lines.empty() || !mesh.points.empty()) {
    for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) all.vertices.push_back(vertex_of(mesh, i, origin, unit));
  }
  const auto append_part = [&](Primitive primitive, const auto& append) {
    Assembly::List& list = all.lists[{primitive, mesh.material}];
    const std::size_t first = list.indices.size();
    append(list.indices);
    if (list.indices.size() > first && !mesh.colors.empty()) list.colored = true;
    list.parts.push_back({first, GLsizei(list.indices.size() - first), bounds_of(mesh)});
  };
  append_part(Primitive::lines, [&](IndexList& to) { append_indices(to, mesh.lines, base); });
  append_part(Primitive::points, [&](IndexList& to) { append_indices(to, mesh.points, base); });
  append_part(Primitive::triangles, [&](IndexList& to) {
    if (flat)
      append_flat_triangles(all, to, mesh, origin, unit);
    else
      append_indices(to, mesh.triangles, base);
  });
  all.lists[{Primitive::triangles, mesh.material}].parts.back().closed = is_closed(mesh);
}

GLint wrap_mode(Wrap wrap) {
  switch (wrap) {
    case Wrap::clamp:
      return GL_CLAMP_TO_EDGE;
    case Wrap::mirror:
      return GL_MIRRORED_REPEAT;
    case Wrap::repeat:
      break;
  }
  return GL_REPEAT;
}

/// Every n-th texel of what is larger than the card allows.
Texture reduced(const Texture& texture, int largest) {
  const int step = (std::max(texture.width, texture.height) + largest - 1) / largest;
  Texture small = texture;
  small.width = std::max(1, texture.width / step);
  small.height = std::max(1, texture.height / step);
  small.rgba.resize(std::size_t(small.width) * std::size_t(small.height) * 4);
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      const std::size_t from = (std::size_t(y) * step * texture.width + std::size_t(x) * step) * 4;
      std::copy_n(&texture.rgba[from], 4, &small.rgba[(std::size_t(y) * small.width + x) * 4]);
    }
  }
  return small;
}

void set_filter(const Texture& texture) {
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap_mode(texture.wrap_u));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap_mode(texture.wrap_v));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, texture.nearest ? GL_NEAREST : GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  constexpr float kAnisotropy = 4.0f;  // floors are seen at grazing angles
  if (epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic"))
    glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, kAnisotropy);
}

/// An sRGB texture, so that filtering happens in linear light.
GlTexture make_texture(const Texture& texture) {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  if (texture.width > largest || texture.height > largest) return make_texture(reduced(texture, largest));
  GlTexture name;
  glBindTexture(GL_TEXTURE_2D, name.get());
  if (texture.width < 1 || texture.height < 1) return name;
  glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, texture.width, texture.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               texture.rgba.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  set_filter(texture);
  return name;
}

GLenum mode_of(Primitive primitive) {
  switch (primitive) {
    case Primitive::lines:
      return GL_LINES;
    case Primitive::points:
      return GL_POINTS;
    case Primitive::triangles:
      break;
  }
  return GL_TRIANGLES;
}

bool reaches(const Part& part, const ConvexBody& body) {
  return !body.empty() && !misses(body, part.bounds.min, part.bounds.max);
}

}  // namespace

SceneBuffers::SceneBuffers() {
  glBindVertexArray(array_.get());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.get());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.get());
  const Attribute attributes[] = {{0, 3, offsetof(Vertex, position)},
                                  {1, 3, offsetof(Vertex, normal)},
                                  {2, 2, offsetof(Vertex, texcoord)},
                                  {3, 4, offsetof(Vertex, color)}};
  declare_attributes(sizeof(Vertex), attributes);
  glBindVertexArray(0);
}

void SceneBuffers::set_frame(const Bounds& bounds) {
  glm::dvec3 origin(0.0);
  double unit = 1.0;
  if (!bounds.empty()) {
    const glm::dvec3 half = 0.5 * (bounds.max - bounds.min);
    origin = bounds.min + half;
    unit = std::max({half.x, half.y, half.z});
    if (!(unit > 0.0)) unit = 1.0;  // a single point
  }
  world_from_local_ = glm::scale(glm::translate(glm::dmat4(1.0), origin), glm::dvec3(unit));
  local_from_world_ = glm::translate(glm::scale(glm::dmat4(1.0), glm::dvec3(1.0 / unit)), -origin);
}

void SceneBuffers::upload(const Scene& scene) {
  ++revision_;
  set_frame(scene.bounds);
  materials_ = scene.materials;
  Assembly all;
  for (const Mesh& mesh : scene.meshes) append_mesh(all, mesh, glm::dvec3(world_from_local_[3]), world_from_local_[0][0]);

  batches_.clear();
  IndexList indices;
  for (auto& [key, list] : all.lists) {
    if (list.indices.empty()) continue;
    for (Part& part : list.parts) part.first += indices.size();
    batches_.push_back(
        {key.first, key.second, indices.size(), GLsizei(list.indices.size()), std::move(list.parts), list.colored});
    indices.insert(indices.end(), list.indices.begin(), list.indices.end());
  }
  glBindVertexArray(array_.get());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.get());
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(all.vertices.size() * sizeof(Vertex)), all.vertices.data(), GL_STATIC_DRAW);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(indices.size() * sizeof(indices[0])), indices.data(), GL_STATIC_DRAW);
  glBindVertexArray(0);

  textures_.clear();
  for (const Texture& texture : scene.textures) textures_.push_back(make_texture(texture));
}

std::string SceneBuffers::defines(const Batch& batch) const {
  return std::string(textured(batch) ? "#define TEXTURED\n" : "") + (batch.colored ? "#define COLORED\n" : "");
}

void SceneBuffers::bind_material(const Batch& batch, Program& program) const {
  const Material& m = material(batch);
  program.set("u_base_color", m.base_color);
  program.set("u_alpha_cutoff", m.alpha_cutoff);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, textured(batch) ? textures_[std::size_t(m.texture)].get() : 0);
}

void SceneBuffers::draw_range(Primitive primitive, std::size_t first, GLsizei count) const {
  glDrawElements(mode_of(primitive), count, GL_UNSIGNED_INT, reinterpret_cast<const void*>(first * sizeof(std::uint32_t)));
}

Bounds SceneBuffers::bounds_inside(Primitive primitive, const ConvexBody& body) const {
  Bounds bounds;
  for (const Batch& batch : batches_) {
    if (batch.primitive != primitive) continue;
    for (const Part& part : batch.parts)
      if (part.count > 0 && reaches(part, body)) bounds.add(part.bounds.min), bounds.add(part.bounds.max);
  }
  return bounds;
}

std::size_t SceneBuffers::draw_parts(const Batch& batch, const std::function<bool(std::size_t)>& wanted) const {
  std::size_t drawn = 0, first = 0;
  GLsizei count = 0;
  const auto flush = [&] {
    if (count > 0) draw_range(batch.primitive, first, count);
    drawn += std::size_t(count);
    count = 0;
  };
  for (std::size_t i = 0; i < batch.parts.size(); ++i) {
    const Part& part = batch.parts[i];
    if (!wanted(i)) continue;
    if (first + std::size_t(count) != part.first) flush();
    if (count == 0) first = part.first;
    count += part.count;
  }
  flush();
  return drawn;
}

std::size_t SceneBuffers::draw_inside(const Batch& batch, const ConvexBody& body) const {
  return draw_parts(batch, [&](std::size_t i) { return reaches(batch.parts[i], body); });
}

}  // namespace psm::gl
