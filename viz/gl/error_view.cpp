// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/error_view.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace psm {
namespace {

struct Kind {
  const char* name;
  std::array<std::uint8_t, 3> color;
};

// Of the palette: orange, blue, vermillion, yellow and reddish purple.
constexpr std::array<Kind, kErrorKinds> kinds{{{"too few texels, lit", {0xE6, 0x9F, 0x00}},
                                               {"too few texels, dark", {0x00, 0x72, 0xB2}},
                                               {"leak, lit", {0xC4, 0x3C, 0x00}},
                                               {"outside, lit", {0xF0, 0xE4, 0x42}},
                                               {"acne, dark", {0x9C, 0x3F, 0x77}}}};
// Truth, by Lit: what is not seen stays as the view has it.
constexpr std::array<std::uint8_t, 4> greys{0, 0x68, 0x8C, 0xE8};

glm::ivec2 size_within(const ImageSettings& image, double most_pixels) {
  const double factor = std::min(1.0, std::sqrt(most_pixels / (double(image.width) * image.height)));
  return glm::max(glm::ivec2(1), glm::ivec2(int(factor * image.width), int(factor * image.height)));
}

ErrorKind kind_of(ErrorCause cause, bool truly_dark) {
  if (cause == ErrorCause::outside) return ErrorKind::outside;
  if (cause == ErrorCause::leak) return ErrorKind::leak;
  if (cause == ErrorCause::acne) return ErrorKind::acne;
  return truly_dark ? ErrorKind::resolution_lit : ErrorKind::resolution_dark;
}

std::string percent(std::size_t part, std::size_t whole) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g %%", whole ? 100.0 * double(part) / double(whole) : 0.0);
  return text;
}

}  // namespace

ErrorView compare_with_truth(Renderer& renderer, const RayTracer& tracer, const Analysis& analysis, double most_pixels) {
  const Experiment& x = analysis.experiment;
  const glm::ivec2 size = size_within(x.image, most_pixels);
  const VisibleImage seen = see(tracer, x, size.x, size.y);
  const std::vector<Lit> truth = trace_light(tracer, seen, x);
  const std::vector<MapVerdict> verdicts = renderer.read_verdicts(analysis, size.x, size.y);
  const std::vector<ErrorCause> causes = find_errors(truth, verdicts, texel_sizes(seen, truth, analysis), size.x, size.y);
  ErrorView view;
  view.image = {size.x, size.y, std::vector<std::uint8_t>(truth.size() * 4, 255)};
  view.errors = count_errors(truth, causes);
  view.reduced = size != glm::ivec2(x.image.width, x.image.height);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    std::uint8_t* pixel = &view.image.rgba[4 * i];
    std::fill(pixel, pixel + 3, greys[std::size_t(truth[i])]);
    if (truth[i] == Lit::unseen) pixel[3] = 0;
    if (causes[i] == ErrorCause::none) continue;
    const std::size_t kind = std::size_t(kind_of(causes[i], truth[i] == Lit::dark));
    std::copy(kinds[kind].color.begin(), kinds[kind].color.end(), pixel);
    ++view.by_kind[kind];
  }
  return view;
}

void show_errors(ViewPicture& eye, const ErrorView& view) {
  eye.cover = view.image;
  eye.texel_step = 0;  // under the cover
  eye.legend = {};
  const ShadowError& e = view.errors;
  const std::string size = std::to_string(view.image.width) + " x " + std::to_string(view.image.height);
  eye.legend.title = "errors against truth, " + size + (view.reduced ? " (reduced)" : "");
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const std::size_t count = view.by_kind[i];
    if (count == 0) continue;
    const glm::vec3 color(kinds[i].color[0], kinds[i].color[1], kinds[i].color[2]);
    eye.legend.entries.push_back(
        {color / 255.0f, std::string(kinds[i].name) + ": " + std::to_string(count) + ", " + percent(count, e.compared)});
  }
  eye.legend.lines.push_back("wrong: " + percent(e.wrongly_lit + e.wrongly_dark, e.compared) + "; lit " +
                             percent(e.wrongly_lit, e.compared) + ", dark " + percent(e.wrongly_dark, e.compared));
}

void announce_errors(ViewPicture& eye) { eye.legend.lines.push_back("errors: traced when nothing moves"); }

}  // namespace psm
