// SPDX-License-Identifier: GPL-3.0-or-later
// The scene on the graphics card. Positions are local: (world - centre of bounds) / half the largest side, subtracted in double,
// so that scenes far from the origin, huge or tiny, keep all the bits that a float has.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "geom/convex_body.h"
#include "gl/gl_objects.h"
#include "scene/scene.h"

namespace psm::gl {

enum class Primitive { triangles, lines, points };

/// One mesh's share of a batch.
struct Part {
  std::size_t first = 0;  // in indices
  GLsizei count = 0;
  Bounds bounds;        // world space
  bool closed = false;  // triangles: see closed_mesh.h
};

/// All indices of one material and primitive.
struct Batch {
  Primitive primitive = Primitive::triangles;
  int material = 0;
  std::size_t first = 0;  // in indices
  GLsizei count = 0;
  std::vector<Part> parts;
  bool colored = false;  // at its vertices
};

class SceneBuffers {
 public:
  SceneBuffers();
  void upload(const Scene& scene);

  const glm::dmat4& world_from_local() const { return world_from_local_; }
  const glm::dmat4& local_from_world() const { return local_from_world_; }
  const std::vector<Batch>& batches() const { return batches_; }
  const Material& material(const Batch& batch) const { return materials_[std::size_t(batch.material)]; }

  /// Another number after each upload.
  int revision() const { return revision_; }

  void bind() const { glBindVertexArray(array_.get()); }
  bool textured(const Batch& batch) const { return std::size_t(material(batch).texture) < textures_.size(); }
  /// The #define lines for programs that draw it.
  std::string defines(const Batch& batch) const;
  /// Sets the material's uniforms of the program in use, and its texture on unit 0.
  void bind_material(const Batch& batch, Program& program) const;
  /// Around the parts of this kind that reach into the body.
  Bounds bounds_inside(Primitive primitive, const ConvexBody& body) const;
  /// Only the parts that `wanted` returns true for, by their index in the batch. Returns how many indices that were.
  std::size_t draw_parts(const Batch& batch, const std::function<bool(std::size_t)>& wanted) const;
  /// Only the parts that reach into the body. Returns how many indices that were.
  std::size_t draw_inside(const Batch& batch, const ConvexBody& body) const;

 private:
  void draw_range(Primitive primitive, std::size_t first, GLsizei count) const;
  void set_frame(const Bounds& bounds);

  glm::dmat4 world_from_local_{1.0}, local_from_world_{1.0};
  std::vector<Material> materials_;
  std::vector<Batch> batches_;
  std::vector<GlTexture> textures_;
  VertexArray array_;
  Buffer vertices_, indices_;
  int revision_ = 0;
};

}  // namespace psm::gl
