// SPDX-License-Identifier: GPL-3.0-or-later
// OpenGL names that delete themselves, and programs made from assets/shaders. A current context is needed from construction to
// destruction.
#pragma once

#include <epoxy/gl.h>

#include <cassert>
#include <filesystem>
#include <glm/glm.hpp>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>

namespace psm::gl {

/// Owns one OpenGL name; Kind knows how to make and to delete it.
template <class Kind>
class Name {
 public:
  Name() { Kind::make(1, &name_); }
  ~Name() {
    if (name_ != 0) Kind::remove(1, &name_);
  }
  Name(Name&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Name& operator=(Name&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  GLuint get() const { return name_; }

 private:
  GLuint name_ = 0;
};

struct BufferKind {
  static void make(GLsizei n, GLuint* names) { glGenBuffers(n, names); }
  static void remove(GLsizei n, const GLuint* names) { glDeleteBuffers(n, names); }
};
struct VertexArrayKind {
  static void make(GLsizei n, GLuint* names) { glGenVertexArrays(n, names); }
  static void remove(GLsizei n, const GLuint* names) { glDeleteVertexArrays(n, names); }
};
struct TextureKind {
  static void make(GLsizei n, GLuint* names) { glGenTextures(n, names); }
  static void remove(GLsizei n, const GLuint* names) { glDeleteTextures(n, names); }
};
struct SamplerKind {
  static void make(GLsizei n, GLuint* names) { glGenSamplers(n, names); }
  static void remove(GLsizei n, const GLuint* names) { glDeleteSamplers(n, names); }
};
struct FramebufferKind {
  static void make(GLsizei n, GLuint* names) { glGenFramebuffers(n, names); }
  static void remove(GLsizei n, const GLuint* names) { glDeleteFramebuffers(n, names); }
};
struct RenderbufferKind {
  static void make(GLsizei n, GLuint* names) { glGenRenderbuffers(n, names); }
  static void remove(GLsizei n, const GLuint* names) { glDeleteRenderbuffers(n, names); }
};

using Buffer = Name<BufferKind>;
using VertexArray = Name<VertexArrayKind>;
using GlTexture = Name<TextureKind>;
using Sampler = Name<SamplerKind>;
using Framebuffer = Name<FramebufferKind>;
using Renderbuffer = Name<RenderbufferKind>;

/// NAME.vert and NAME.frag of the folder, behind the #version line that the current context needs. Ends the program with a clear
/// line if a file is missing or does not compile: the installation is broken then.
class Program {
 public:
  /// `defines`: lines such as "#define NAME\n", for both shaders. `library`: NAME.glsl, before the fragment shader.
  Program(const std::filesystem::path& shaders, const std::string& vertex, const std::string& fragment,
          const std::string& defines = "", const std::string& library = "");
  ~Program() { glDeleteProgram(name_); }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void use() const { glUseProgram(name_); }

  // Of the program in use. Names that the compiler dropped are ignored, as OpenGL does.
  void set(const char* name, int value) { glUniform1i(location(name), value); }
  void set(const char* name, float value) { glUniform1f(location(name), value); }
  void set(const char* name, const glm::ivec2& v) { glUniform2i(location(name), v.x, v.y); }
  void set(const char* name, const glm::vec2& v) { glUniform2f(location(name), v.x, v.y); }
  void set(const char* name, const glm::vec3& v) { glUniform3f(location(name), v.x, v.y, v.z); }
  void set(const char* name, const glm::vec4& v) { glUniform4f(location(name), v.x, v.y, v.z, v.w); }
  void set(const char* name, const glm::mat4& m) { set(name, std::span<const glm::mat4>(&m, 1)); }
  void set(const char* name, std::span<const glm::mat4> matrices);
  void set(const char* name, std::span<const glm::vec3> vectors);

 private:
  GLint location(const char* name);

  GLuint name_ = 0;
  std::unordered_map<std::string, GLint> locations_;
};

/// A shader input made of floats: its location, how many, and where they start in a vertex (bytes).
struct Attribute {
  GLuint location;
  GLint floats;
  std::size_t offset;
};

/// Vertices that are written anew for every picture, as one interleaved buffer.
class VertexStream {
 public:
  VertexStream(std::size_t stride, std::initializer_list<Attribute> attributes);

  template <class Vertex>
  void upload(std::span<const Vertex> vertices) {
    assert(sizeof(Vertex) == stride_);
    upload_bytes(vertices.data(), vertices.size_bytes());
  }
  void draw_triangles() const;

 private:
  void upload_bytes(const void* data, std::size_t bytes);

  std::size_t stride_;
  GLsizei count_ = 0;
  VertexArray array_;
  Buffer buffer_;
};

/// Declares the attributes of the buffer that is bound to GL_ARRAY_BUFFER.
void declare_attributes(std::size_t stride, std::span<const Attribute> attributes);

/// The one narrowing from double to float, of a composed matrix that acts on homogeneous points: divided by its largest entry
/// first, so that no scale overflows. Nothing if an entry is not finite or all are zero.
std::optional<glm::mat4> narrow(const glm::dmat4& matrix);

/// Whether counter-clockwise triangles turn clockwise: they stay as they are where the determinant is negative, as OpenGL's own
/// projections look down -z.
inline bool front_is_clockwise(const glm::dmat4& clip_from_space) { return glm::determinant(clip_from_space) > 0.0; }

/// Ends the program with this line.
[[noreturn]] void fail(const std::string& line);

}  // namespace psm::gl
