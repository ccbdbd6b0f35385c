// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/caption.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

namespace psm {

/// The atlas works without any ImGui context: it is a rasteriser here.
struct Caption::State {
  ImFontAtlas atlas;
  ImFont* font = nullptr;
  unsigned char* coverage = nullptr;
  int width = 0, height = 0;
};

namespace {

/// Calls `visit(glyph, pen_x)` for each character, and returns where the pen ends.
template <class Visit>
double for_each_glyph(const ImFont& font, const std::string& text, const Visit& visit) {
  double pen = 0.0;
  for (const char *at = text.data(), *end = at + text.size(); at < end;) {
    unsigned int code = 0;
    at += std::max(1, ImTextCharFromUtf8(&code, at, end));
    const ImFontGlyph* glyph = font.FindGlyph(ImWchar(code));
    visit(*glyph, pen);
    pen += glyph->AdvanceX;
  }
  return pen;
}

void blend(std::uint8_t* pixel, const glm::vec3& color, float coverage) {
  for (int i = 0; i < 3; ++i)
    pixel[i] = std::uint8_t(std::lround(float(pixel[i]) * (1.0f - coverage) + color[i] * 255.0f * coverage));
}

}  // namespace

Caption::Caption(const std::filesystem::path& font, double size) : state_(std::make_unique<State>()) {
  static const ImWchar ranges[] = {0x0020, 0x00FF, 0x0370, 0x03FF, 0x2010, 0x205F, 0x2070,
                                   0x209F, 0x2190, 0x22FF, 0x25A0, 0x25FF, 0};
  ImFontConfig config;
  config.OversampleH = config.OversampleV = 1;  // one texel of the atlas is one pixel of the picture
  config.PixelSnapH = true;
  state_->font = state_->atlas.AddFontFromFileTTF(font.c_str(), float(std::max(6.0, std::round(size))), &config, ranges);
  state_->atlas.GetTexDataAsAlpha8(&state_->coverage, &state_->width, &state_->height);
}

Caption::~Caption() = default;

double Caption::width(const std::string& text) const {
  return for_each_glyph(*state_->font, text, [](const ImFontGlyph&, double) {});
}

void Caption::draw(Image& image, int x, int y, const std::string& text, const glm::vec3& color) const {
  for_each_glyph(*state_->font, text, [&](const ImFontGlyph& glyph, double pen) {
    const int u = int(std::lround(glyph.U0 * state_->width)), v = int(std::lround(glyph.V0 * state_->height));
    const int columns = int(std::lround((glyph.U1 - glyph.U0) * state_->width));
    const int rows = int(std::lround((glyph.V1 - glyph.V0) * state_->height));
    const int left = x + int(std::lround(pen + glyph.X0)), top = y + int(std::lround(glyph.Y0));
    for (int j = std::max(0, -top); j < std::min(rows, image.height - top); ++j)
      for (int i = std::max(0, -left); i < std::min(columns, image.width - left); ++i)
        blend(&image.rgba[(std::size_t(top + j) * image.width + left + i) * 4], color,
              state_->coverage[std::size_t(v + j) * state_->width + u + i] / 255.0f);
  });
}

}  // namespace psm
