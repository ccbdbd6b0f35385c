// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/gl_objects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace psm::gl {
namespace {

constexpr const char* kCorePrefix = "#version 330 core\n";
constexpr const char* kEsPrefix =
    "#version 300 es\n"
    "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"
    "precision highp sampler2DArray;\nprecision highp sampler2DArrayShadow;\n";

std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) fail("psmlab: " + file.string() + ": cannot be read; the installation is incomplete");
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

GLuint compile(GLenum stage, const std::filesystem::path& file, const std::string& defines) {
  const std::string text = read_text(file);
  const std::array<const char*, 3> parts{epoxy_is_desktop_gl() ? kCorePrefix : kEsPrefix, defines.c_str(), text.c_str()};
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, GLsizei(parts.size()), parts.data(), nullptr);
  glCompileShader(shader);
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return shader;
  std::array<char, 2048> log{};
  glGetShaderInfoLog(shader, GLsizei(log.size()), nullptr, log.data());
  fail("psmlab: " + file.string() + ": does not compile: " + log.data());
}

}  // namespace

void fail(const std::string& line) {
  std::fprintf(stderr, "%s\n", line.c_str());
  std::exit(1);
}

Program::Program(const std::filesystem::path& shaders, const std::string& vertex, const std::string& fragment,
                 const std::string& defines, const std::string& library)
    : name_(glCreateProgram()) {
  const std::string shared = library.empty() ? "" : read_text(shaders / (library + ".glsl"));
  for (const GLuint shader : {compile(GL_VERTEX_SHADER, shaders / (vertex + ".vert"), defines),
                              compile(GL_FRAGMENT_SHADER, shaders / (fragment + ".frag"), defines + shared)}) {
    glAttachShader(name_, shader);
    glDeleteShader(shader);  // once the program goes
  }
  glLinkProgram(name_);
  GLint linked = GL_FALSE;
  glGetProgramiv(name_, GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return;
  std::array<char, 2048> log{};
  glGetProgramInfoLog(name_, GLsizei(log.size()), nullptr, log.data());
  fail("psmlab: " + (shaders / vertex).string() + ".vert with " + fragment + ".frag: does not link: " + log.data());
}

void Program::set(const char* name, std::span<const glm::mat4> matrices) {
  if (!matrices.empty()) glUniformMatrix4fv(location(name), GLsizei(matrices.size()), GL_FALSE, &matrices[0][0][0]);
}

void Program::set(const char* name, std::span<const glm::vec3> vectors) {
  if (!vectors.empty()) glUniform3fv(location(name), GLsizei(vectors.size()), &vectors[0][0]);
}

GLint Program::location(const char* name) {
  const auto [entry, is_new] = locations_.try_emplace(name, -1);
  if (is_new) entry->second = glGetUniformLocation(name_, name);
  return entry->second;
}

void declare_attributes(std::size_t stride, std::span<const Attribute> attributes) {
  for (const Attribute& a : attributes) {
    glEnableVertexAttribArray(a.location);
    glVertexAttribPointer(a.location, a.floats, GL_FLOAT, GL_FALSE, GLsizei(stride), reinterpret_cast<const void*>(a.offset));
  }
}

VertexStream::VertexStream(std::size_t stride, std::initializer_list<Attribute> attributes) : stride_(stride) {
  glBindVertexArray(array_.get());
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.get());
  declare_attributes(stride, std::span<const Attribute>(attributes.begin(), attributes.size()));
  glBindVertexArray(0);
}

void VertexStream::upload_bytes(const void* data, std::size_t bytes) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.get());
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(bytes), data, GL_STREAM_DRAW);
  count_ = GLsizei(bytes / stride_);
}

void VertexStream::draw_triangles() const {
  if (count_ == 0) return;
  glBindVertexArray(array_.get());
  glDrawArrays(GL_TRIANGLES, 0, count_);
}

std::optional<glm::mat4> narrow(const glm::dmat4& matrix) {
  double largest = 0.0;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!std::isfinite(matrix[column][row])) return std::nullopt;
      largest = std::max(largest, std::abs(matrix[column][row]));
    }
  }
  if (largest == 0.0) return std::nullopt;
  return glm::mat4(matrix / largest);
}

}  // namespace psm::gl
