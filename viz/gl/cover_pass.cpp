// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/cover_pass.h"

#include <array>

#include "gl/gl_state.h"

namespace psm::gl {
namespace {

struct Corner {
  glm::vec4 clip;
  glm::vec2 map;
};

void upload(const GlTexture& texture, const Image& image) {
  glBindTexture(GL_TEXTURE_2D, texture.get());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  glGenerateMipmap(GL_TEXTURE_2D);  // single wrong pixels must not vanish in a small view
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

}  // namespace

CoverPass::CoverPass(const std::filesystem::path& shaders)
    : program_(shaders, "map_depth", "cover"),
      corners_(sizeof(Corner), {{0, 4, offsetof(Corner, clip)}, {1, 2, offsetof(Corner, map)}}) {}

void CoverPass::draw(const ViewPicture& picture) {
  if (!picture.cover) return;
  const GlTexture texture;
  glActiveTexture(GL_TEXTURE0);
  upload(texture, *picture.cover);
  const glm::vec4 rect(picture.image_rect);
  const auto corner = [&](float u, float v) {
    return Corner{{glm::mix(rect.x, rect.z, u), glm::mix(rect.y, rect.w, v), 0.0f, 1.0f}, {u, v}};
  };
  const std::array<Corner, 6> corners{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 0), corner(1, 1), corner(0, 1)};
  program_.use();
  program_.set("u_cover", 0);
  glDisable(GL_DEPTH_TEST);
  enable_blending();
  corners_.upload(std::span<const Corner>(corners));
  corners_.draw_triangles();
  glDisable(GL_BLEND);
  glBindTexture(GL_TEXTURE_2D, 0);
}

}  // namespace psm::gl
