// SPDX-License-Identifier: GPL-3.0-or-later
// PDF by Cairo: text stays text, with the part of the typeface that it needs embedded.
#include "figure/page.h"

#ifdef PSMLAB_CAIRO
#include <cairo-pdf.h>

#include <algorithm>
#include <cmath>
#include <memory>
#endif

namespace psm {

#ifdef PSMLAB_CAIRO
namespace {

constexpr double kPointsPerPixel = 0.75;  // 72 to the inch, 96 to the inch

struct Destroy {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_pattern_t* pattern) const { cairo_pattern_destroy(pattern); }
};
template <class T>
using Owned = std::unique_ptr<T, Destroy>;

cairo_status_t append(void* bytes, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

/// Cairo wants native-endian words with colours multiplied by their opacity.
std::vector<std::uint32_t> premultiplied(const Image& image) {
  std::vector<std::uint32_t> words(image.rgba.size() / 4);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::uint8_t* p = &image.rgba[4 * i];
    const auto times = [&](int channel) { return std::uint32_t((p[channel] * p[3] + 127) / 255); };
    words[i] = std::uint32_t(p[3]) << 24 | times(0) << 16 | times(1) << 8 | times(2);
  }
  return words;
}

class PdfWriter {
 public:
  explicit PdfWriter(cairo_t* context) : c_(context) {
    cairo_select_font_face(c_, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  }

  void operator()(const PageLine& line) {
    if (std::abs(line.opacity_a - line.opacity_b) > 0.004) {
      const Owned<cairo_pattern_t> fade(cairo_pattern_create_linear(line.a.x, line.a.y, line.b.x, line.b.y));
      add_stop(fade.get(), 0.0, line.color, line.opacity_a);
      add_stop(fade.get(), 1.0, line.color, line.opacity_b);
      cairo_set_source(c_, fade.get());
    } else {
      set_color(glm::vec4(line.color, float(line.opacity_a)));
    }
    const double dash[] = {line.dash_on, line.dash_off};
    cairo_set_dash(c_, dash, line.dash_on > 0.0 ? 2 : 0, 0.0);
    cairo_set_line_width(c_, line.width);
    cairo_move_to(c_, line.a.x, line.a.y);
    cairo_line_to(c_, line.b.x, line.b.y);
    cairo_stroke(c_);
    cairo_set_dash(c_, dash, 0, 0.0);
  }

  void operator()(const PagePolygon& polygon) {
    for (const glm::dvec2& p : polygon.corners) cairo_line_to(c_, p.x, p.y);
    cairo_close_path(c_);
    set_color(polygon.fill);
    cairo_fill(c_);
  }

  void operator()(const PageBox& box) {
    rounded(box);
    set_color(box.fill);
    cairo_fill_preserve(c_);
    set_color(box.rim);
    cairo_set_line_width(c_, box.rim_width);
    if (box.rim_width > 0.0) cairo_stroke(c_);
    cairo_new_path(c_);
  }

  void operator()(const PageText& text) {
    cairo_set_font_size(c_, kEmPerHeight * text.size.y);
    cairo_text_extents_t extents;
    cairo_text_extents(c_, text.text.c_str(), &extents);
    set_color(glm::vec4(text.color, 1.0f));
    cairo_move_to(c_, text.top_left.x + 0.5 * (text.size.x - extents.x_advance),
                  text.top_left.y + kAscentPerHeight * text.size.y);
    cairo_show_text(c_, text.text.c_str());
    cairo_new_path(c_);
  }

  void operator()(const PageImage& image) {
    std::vector<std::uint32_t> words = premultiplied(image.image);
    const Owned<cairo_surface_t> surface(cairo_image_surface_create_for_data(reinterpret_cast<unsigned char*>(words.data()),
                                                                             CAIRO_FORMAT_ARGB32, image.image.width,
                                                                             image.image.height, 4 * image.image.width));
    cairo_save(c_);
    cairo_translate(c_, image.top_left.x, image.top_left.y);
    cairo_scale(c_, image.size.x / image.image.width, image.size.y / image.image.height);
    cairo_set_source_surface(c_, surface.get(), 0.0, 0.0);
    cairo_paint(c_);
    cairo_restore(c_);
    cairo_surface_finish(surface.get());  // the pixels go away with this function
  }

 private:
  void set_color(const glm::vec4& c) { cairo_set_source_rgba(c_, c.r, c.g, c.b, c.a); }
  static void add_stop(cairo_pattern_t* pattern, double offset, const glm::vec3& color, double opacity) {
    cairo_pattern_add_color_stop_rgba(pattern, offset, color.r, color.g, color.b, opacity);
  }

  void rounded(const PageBox& box) {
    const double r = std::min({box.radius, 0.5 * box.size.x, 0.5 * box.size.y}), quarter = std::acos(0.0);
    const glm::dvec2 low = box.top_left + r, high = box.top_left + box.size - r;
    cairo_new_sub_path(c_);
    cairo_arc(c_, high.x, low.y, r, -quarter, 0.0);
    cairo_arc(c_, high.x, high.y, r, 0.0, quarter);
    cairo_arc(c_, low.x, high.y, r, quarter, 2.0 * quarter);
    cairo_arc(c_, low.x, low.y, r, 2.0 * quarter, 3.0 * quarter);
    cairo_close_path(c_);
  }

  cairo_t* c_;
};

void draw_panel(cairo_t* context, const PagePanel& panel) {
  cairo_save(context);
  cairo_rectangle(context, panel.top_left.x, panel.top_left.y, panel.size.x, panel.size.y);
  cairo_clip(context);
  PdfWriter writer(context);
  for (const PageItem& item : panel.items) std::visit(writer, item);
  cairo_restore(context);
}

void describe(cairo_surface_t* surface, const Page& page) {
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, page.title.c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_KEYWORDS, page.parameters.c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "psmlab");
}

}  // namespace

Result<std::string> page_pdf(const Page& page) {
  std::string bytes;
  const glm::dvec2 points = kPointsPerPixel * page.size;
  const Owned<cairo_surface_t> surface(cairo_pdf_surface_create_for_stream(append, &bytes, points.x, points.y));
  describe(surface.get(), page);
  Owned<cairo_t> context(cairo_create(surface.get()));
  cairo_scale(context.get(), kPointsPerPixel, kPointsPerPixel);
  if (page.background) {
    cairo_set_source_rgb(context.get(), page.background->r, page.background->g, page.background->b);
    cairo_paint(context.get());
  }
  for (const PagePanel& panel : page.panels) draw_panel(context.get(), panel);
  const cairo_status_t drawn = cairo_status(context.get());
  context.reset();
  cairo_surface_finish(surface.get());
  const cairo_status_t status = drawn != CAIRO_STATUS_SUCCESS ? drawn : cairo_surface_status(surface.get());
  if (status != CAIRO_STATUS_SUCCESS) return InputError{std::string("PDF: Cairo says: ") + cairo_status_to_string(status)};
  return bytes;
}

std::optional<InputError> pdf_missing() { return std::nullopt; }
#else
std::optional<InputError> pdf_missing() {
  return InputError{"PDF: this program was built without Cairo; allowed: .svg or .png, or a build with libcairo2-dev"};
}

Result<std::string> page_pdf(const Page&) { return *pdf_missing(); }
#endif

}  // namespace psm
