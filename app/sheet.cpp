// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sheet.h"

#include <algorithm>
#include <cmath>

#include "app/assets.h"
#include "app/caption.h"
#include "app/compared_sides.h"
#include "app/pixels.h"
#include "figure/png.h"
#include "figure/view_panel.h"
#include "gl/traced_overlay.h"
#include "ui/probe_hover.h"

namespace psm {
namespace {

constexpr double kStatusHeight = 18.0, kStatusInset = 5.0;  // pixels at scale 1
constexpr int kMostRasterPixels = 16 << 20;                 // of a panel that is drawn larger than it is shown

/// Means of two by two pixels, each with the weight of its opacity.
Image halved(const Image& image) {
  Image half{image.width / 2, image.height / 2, {}};
  half.rgba.reserve(std::size_t(half.width) * half.height * 4);
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x) {
      int sum[4] = {};
      for (int k = 0; k < 4; ++k) {
        const std::uint8_t* p = &image.rgba[(std::size_t(2 * y + k / 2) * image.width + 2 * x + k % 2) * 4];
        for (int c = 0; c < 3; ++c) sum[c] += p[c] * p[3];
        sum[3] += p[3];
      }
      for (int c = 0; c < 3; ++c) half.rgba.push_back(std::uint8_t(sum[3] ? (sum[c] + sum[3] / 2) / sum[3] : 0));
      half.rgba.push_back(std::uint8_t((sum[3] + 2) / 4));
    }
  return half;
}

/// How many pixels along a side are drawn for one.
int samples_along(const glm::ivec2& size) { return std::int64_t(size.x) * size.y * 4 <= kMostRasterPixels ? 2 : 1; }

glm::vec3 status_color(Theme theme) { return glm::vec3(theme == Theme::dark ? 0.92f : 0.08f); }

std::string status_text(const Analysis& analysis) {
  return light_case_text(analysis) + "   |   " + name_of(analysis.technique_used);
}

}  // namespace

std::string parameters_of(const Sheet& sheet) {
  std::string text = "[";
  for (const SheetPanel& panel : sheet.panels)
    text += std::string(text.size() > 1 ? "," : "") + "{\"view\": \"" + name_of(panel.view) + "\"" +
            ", \"experiment\": " + experiment_to_json(panel.loaded->experiment) + "}";
  return text + "]";
}

struct SheetPainter::State {
  Renderer renderer{assets_folder(), font_file()};
  std::shared_ptr<const LoadedExperiment> loaded;
  std::optional<RayTracer> tracer;
  Analysis analysis;
  std::optional<Probe> probe;
  const Result<FontFace> font = FontFace::load(font_file());

  void prepare(const std::shared_ptr<const LoadedExperiment>& wanted) {
    if (loaded == wanted) return;
    const bool same_scene = loaded && loaded->base == wanted->base && loaded->experiment.scene == wanted->experiment.scene;
    loaded = wanted;
    if (!same_scene) {
      tracer.emplace(loaded->scene);
      renderer.set_scene(loaded->scene);
    }
    analysis = analyze_with_statistics(loaded->experiment, loaded->scene, *tracer);
    probe = probe_at(loaded->experiment.view.probe, *tracer, analysis);
    renderer.update_shadow_map(analysis);
  }

  ViewPicture describe(const SheetPanel& panel, const Sheet& sheet) {
    prepare(panel.loaded);
    std::optional<TracedOverlay> traced;
    if (panel.view == ViewId::eye && takes_rays(analysis.experiment.view.eye_overlay))
      traced = trace_overlay(renderer, *tracer, analysis, kAllPixels);
    const ViewExtras extras{panel.emphasis, probe ? &*probe : nullptr, traced ? &*traced : nullptr,
                            font ? shown_part(panel, analysis, *font, sheet.scale) : ShownPart{}};
    ViewPicture picture = describe_view(panel.view, analysis, panel.size, sheet.scale, extras);
    if (panel.title) picture.title = *panel.title;
    return picture;
  }

  Image draw(const ViewPicture& picture, const Sheet& sheet, const glm::ivec2& size, int samples) {
    renderer.draw_view(picture, analysis, size * samples, sheet.scale * samples, sheet.theme,
                       sheet.transparent ? Backdrop::none : Backdrop::ground);
    return renderer.read_view(picture.id);
  }

  /// The scene and what it hides partly, and the depth that decides what it hides.
  ViewRaster raster(const ViewPicture& picture, const Sheet& sheet, const glm::ivec2& size, const PictureFrame& frame) {
    ViewRaster raster;
    if (picture.scene == ScenePicture::none) return raster;
    const int samples = samples_along(size);
    raster.image = draw(picture, sheet, size, samples);
    raster.depth = renderer.read_overlay_depth();
    ViewPicture bare = picture;
    bare.title.clear();
    bare.legend = {};
    bare.list = {};
    bare.list.fills = hidden_fills(picture, frame, raster);
    raster.image = draw(bare, sheet, size, samples);
    return raster;
  }
};

SheetPainter::SheetPainter() : state_(std::make_unique<State>()) {}
SheetPainter::~SheetPainter() = default;

Image SheetPainter::image(const Sheet& sheet) {
  const glm::vec4 background = sheet.transparent ? glm::vec4(0.0f) : glm::vec4(sheet.background, 1.0f);
  Image whole = filled(sheet.size, background);
  std::vector<SidePlate> plates;
  for (const SheetPanel& panel : sheet.panels) {
    const ViewPicture picture = state_->describe(panel, sheet);
    const int samples = sheet.supersampled ? samples_along(panel.size) : 1;
    const Image image = state_->draw(picture, sheet, panel.size, samples);
    paste(samples == 2 ? halved(image) : image, shown_columns(panel), panel.top_left, whole);
    for (const SidePlate& plate : side_plates(panel, state_->analysis, sheet.scale)) plates.push_back(plate);
  }
  const Caption caption(font_file(), kStatusHeight * sheet.scale);
  for (const SidePlate& plate : plates) draw_plate(plate, caption, sheet, whole);
  if (sheet.status_height > 0) {
    const int inset = int(std::lround(kStatusInset * sheet.scale));
    caption.draw(whole, inset, sheet.size.y - sheet.status_height + inset, status_text(state_->analysis),
                 status_color(sheet.theme));
  }
  return whole;
}

Result<Page> SheetPainter::page(const Sheet& sheet) {
  const Result<FontFace>& font = state_->font;
  if (!font) return font.error();
  Page page{sheet.size, std::nullopt, {}, sheet.title, parameters_of(sheet)};
  if (!sheet.transparent) page.background = sheet.background;
  std::vector<SidePlate> plates;
  for (const SheetPanel& panel : sheet.panels) {
    const PictureFrame frame{panel.size, sheet.scale, sheet.theme};
    const ViewPicture picture = state_->describe(panel, sheet);
    page.panels.push_back(view_panel(picture, frame, state_->raster(picture, sheet, panel.size, frame), panel.top_left, *font));
    const glm::ivec2 columns = shown_columns(panel);
    page.panels.back().top_left.x += columns.x;
    page.panels.back().size.x = columns.y - columns.x;
    for (const SidePlate& plate : side_plates(panel, state_->analysis, sheet.scale)) plates.push_back(plate);
  }
  for (const SidePlate& plate : plates) page.panels.push_back(plate_panel(plate, *font, sheet));
  if (sheet.status_height > 0) {
    const std::string text = status_text(state_->analysis);
    const double inset = kStatusInset * sheet.scale;
    const glm::dvec2 top_left(inset, sheet.size.y - sheet.status_height + inset);
    page.panels.push_back(
        {{0.0, 0.0},
         page.size,
         {PageText{top_left, font->text_size(text, kStatusHeight * sheet.scale), text, status_color(sheet.theme)}}});
  }
  return page;
}

Result<std::string> sheet_bytes(SheetPainter& painter, const Sheet& sheet, const std::filesystem::path& file) {
  if (file.extension() == ".png") return png_bytes(painter.image(sheet), parameters_of(sheet));
  const auto page = painter.page(sheet);
  if (!page) return page.error();
  return file.extension() == ".svg" ? Result<std::string>(page_svg(*page)) : page_pdf(*page);
}

}  // namespace psm
