// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/renderer.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "draw/theme.h"
#include "gl/cover_pass.h"
#include "gl/gl_state.h"
#include "gl/list_pass.h"
#include "gl/map_pass.h"
#include "gl/overlay_depth.h"
#include "gl/scene_pass.h"
#include "gl/seen_rect.h"
#include "gl/shadow_pass.h"
#include "gl/view_target.h"
#include "gl/visible_pass.h"

namespace psm {

struct Renderer::State {
  State(const std::filesystem::path& shaders, const std::filesystem::path& font)
      : shadow_pass(shaders),
        scene_pass(shaders),
        map_pass(shaders),
        cover_pass(shaders),
        list_pass(shaders, font),
        overlay_depth(shaders) {}

  gl::ViewTarget& target(ViewId id) { return targets[std::size_t(id)]; }

  gl::SceneBuffers scene;
  gl::ShadowPass shadow_pass;
  gl::ScenePass scene_pass;
  gl::MapPass map_pass;
  gl::CoverPass cover_pass;
  gl::VisiblePass visible_pass;
  gl::ListPass list_pass;
  gl::OverlayDepth overlay_depth;
  gl::MultisampleTarget multisample;
  std::array<gl::ViewTarget, kAllViews.size()> targets;  // by ViewId
};

namespace {

using gl::PixelRect;

/// Clears beside the eye's image.
void clear_outside(const ViewPicture& picture, glm::ivec2 size, const glm::vec4& rgba) {
  const PixelRect image = gl::pixel_rect(picture.image_rect, size);
  for (const PixelRect& bar : {PixelRect{0, 0, image.left, size.y}, PixelRect{image.right, 0, size.x, size.y},
                               PixelRect{0, 0, size.x, image.bottom}, PixelRect{0, image.top, size.x, size.y}}) {
    if (bar.left < bar.right && bar.bottom < bar.top) gl::clear(bar, rgba);
  }
}

/// Whether the picture has a scene that can hide what is drawn over it.
bool has_depth(const ViewPicture& picture) {
  return picture.scene == ScenePicture::shadowed || picture.scene == ScenePicture::projective;
}

PixelRect fills_rect(const ViewPicture& picture, glm::ivec2 size) {
  gl::SeenRect seen;
  for (const DrawFill& fill : picture.list.fills) seen.add_polygon(picture.clip_from_list, fill.corners);
  return seen.pixels(size, 1);
}

PixelRect cover_rect(const ViewPicture& picture, glm::ivec2 size) {
  return picture.cover ? gl::pixel_rect(picture.image_rect, size) : PixelRect{};
}

/// Pixels over nothing come out with their colours multiplied by their opacity.
void divide_by_opacity(std::vector<std::uint8_t>& rgba) {
  for (std::size_t i = 0; i < rgba.size(); i += 4) {
    const int alpha = rgba[i + 3];
    if (alpha == 255 || alpha == 0) continue;
    for (std::size_t k = i; k < i + 3; ++k) rgba[k] = std::uint8_t(std::min(255, (rgba[k] * 255 + alpha / 2) / alpha));
  }
}

}  // namespace

Renderer::Renderer(const std::filesystem::path& assets, const std::filesystem::path& font) {
  const gl::StateGuard guard;
  state_ = std::make_unique<State>(assets / "shaders", font);
}

Renderer::~Renderer() = default;

void Renderer::set_scene(const Scene& scene) {
  const gl::StateGuard guard;
  state_->scene.upload(scene);
  gl::check_errors("set_scene");
}

void Renderer::draw_shadow_map(const Analysis& analysis) {
  const gl::StateGuard guard;
  state_->shadow_pass.draw(state_->scene, analysis);
  gl::check_errors("draw_shadow_map");
}

void Renderer::update_shadow_map(const Analysis& analysis) {
  const gl::StateGuard guard;
  state_->shadow_pass.update(state_->scene, analysis);
  gl::check_errors("update_shadow_map");
}

std::uint32_t Renderer::draw_view(const ViewPicture& picture, const Analysis& analysis, glm::ivec2 size, double scale,
                                  Theme theme, Backdrop backdrop) {
  const gl::StateGuard guard;
  State& s = *state_;
  size = gl::allowed_size(size);
  gl::ViewTarget& target = s.target(picture.id);
  target.resize(size);
  s.multisample.reserve(size);
  // Into a framebuffer of its own, so before this picture's is bound.
  if (picture.scene == ScenePicture::map_depth) s.shadow_pass.find_range();

  glViewport(0, 0, size.x, size.y);
  const bool transparent = backdrop == Backdrop::none;
  const glm::vec4 ground = transparent ? glm::vec4(0.0f) : glm::vec4(picture_ground(theme), 1.0f);
  const glm::vec4 outside = transparent ? ground : glm::vec4(picture_outside(theme), 1.0f);
  const PictureFrame frame{glm::dvec2(size), scale, theme};
  s.overlay_depth.forget();
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
  gl::clear({0, 0, size.x, size.y}, ground);
  clear_outside(picture, size, outside);
  if (picture.scene == ScenePicture::map_depth) s.map_pass.draw(picture, s.shadow_pass, scale, theme);

  // Triangles need several samples a pixel, but only where there are any.
  const bool solid = has_depth(picture);
  const PixelRect scene_rect = solid ? s.scene_pass.reach(picture, s.scene, size, scale) : PixelRect{};
  const PixelRect sampled = joined(joined(scene_rect, fills_rect(picture, size)), cover_rect(picture, size));
  if (!sampled.empty()) {
    s.multisample.clear(sampled, ground);
    if (solid) s.scene_pass.draw(picture, analysis, s.scene, s.shadow_pass, scale, ground);
    s.cover_pass.draw(picture);
    s.list_pass.draw_fills(picture, frame);
    if (solid) s.scene_pass.draw_texel_grid(picture, analysis, s.scene, s.shadow_pass, scale, theme);
    clear_outside(picture, size, outside);  // after the scene: some drivers let multisampled triangles reach beyond a scissor
    target.resolve_from(s.multisample, sampled);
  }
  if (!scene_rect.empty() && !(picture.list.lines.empty() && picture.list.points.empty()))
    s.overlay_depth.take(s.multisample, size, scene_rect);
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
  s.list_pass.draw_lines_and_labels(picture, frame, s.overlay_depth);
  gl::check_errors("draw_view");
  return target.texture();
}

Image Renderer::read_view(ViewId id) {
  const gl::StateGuard guard;
  const gl::ViewTarget& target = state_->target(id);
  Image image{target.size().x, target.size().y, target.read_top_to_bottom()};
  divide_by_opacity(image.rgba);
  return image;
}

std::vector<float> Renderer::read_overlay_depth() {
  const gl::StateGuard guard;
  std::vector<float> depth = state_->overlay_depth.read();
  gl::check_errors("read_overlay_depth");
  return depth;
}

MapReading Renderer::read_map(const Analysis& analysis, int width, int height) {
  const gl::StateGuard guard;
  assert(glm::ivec2(width, height) == gl::allowed_size({width, height}));
  const gl::PlainTarget target({width, height});  // one sample a pixel: a verdict has no shades
  state_->scene_pass.draw_verdicts(analysis, state_->scene, state_->shadow_pass);
  const std::vector<std::uint8_t> rgba = target.read_top_to_bottom();
  MapReading reading;
  for (std::size_t i = 0; i < rgba.size(); i += 4) {
    reading.verdicts.push_back(MapVerdict(rgba[i]));
    reading.lit.push_back(float(rgba[i + 1]) / 255.0f);
  }
  gl::check_errors("read_map");
  return reading;
}

void Renderer::ask_for_visible_points(const Analysis& analysis) {
  const gl::StateGuard guard;
  state_->visible_pass.ask(analysis, state_->scene, state_->scene_pass);
  gl::check_errors("ask_for_visible_points");
}

std::optional<std::vector<SurfacePoint>> Renderer::take_visible_points() {
  const gl::StateGuard guard;
  return state_->visible_pass.take();
}

std::vector<float> Renderer::read_map_depth() {
  const gl::StateGuard guard;
  return state_->shadow_pass.read_depth();
}

std::size_t Renderer::map_triangles() const { return state_->shadow_pass.triangles_drawn(); }

int Renderer::maps_drawn() const { return state_->shadow_pass.times_drawn(); }

int Renderer::map_resolution() const { return state_->shadow_pass.resolution(); }

}  // namespace psm
