// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/error_view.h"

#include <algorithm>

#include "gl/traced_overlay.h"

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

ErrorKind kind_of(ErrorCause cause, bool truly_dark) {
  if (cause == ErrorCause::outside) return ErrorKind::outside;
  if (cause == ErrorCause::leak) return ErrorKind::leak;
  if (cause == ErrorCause::acne) return ErrorKind::acne;
  return truly_dark ? ErrorKind::resolution_lit : ErrorKind::resolution_dark;
}

}  // namespace

ErrorView compare_with_truth(Renderer& renderer, const RayTracer& tracer, const Analysis& analysis, double most_pixels) {
  const Experiment& x = analysis.experiment;
  const glm::ivec2 size = traced_size(x, most_pixels);
  const VisibleImage seen = see(tracer, x, size.x, size.y);
  const std::vector<float> fractions = trace_fractions(tracer, seen, x);
  const std::vector<Lit> truth = lit_by_half(seen, fractions);
  const MapReading map = renderer.read_map(analysis, size.x, size.y);
  const std::vector<ErrorCause> causes = find_errors(truth, map.verdicts, texel_sizes(seen, analysis), size.x, size.y);
  ErrorView view;
  view.image = {size.x, size.y, std::vector<std::uint8_t>(truth.size() * 4, 255)};
  view.errors = count_errors(truth, causes);
  view.lit_difference = lit_difference(fractions, map);
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

Legend error_legend(const ErrorView& view) {
  Legend legend;
  const ShadowError& e = view.errors;
  legend.title = "errors against truth, " + traced_size_text(view.image, view.reduced);
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const std::size_t count = view.by_kind[i];
    if (count == 0) continue;
    const glm::vec3 color(kinds[i].color[0], kinds[i].color[1], kinds[i].color[2]);
    legend.entries.push_back(
        {color / 255.0f, std::string(kinds[i].name) + ": " + std::to_string(count) + ", " + percent_text(count, e.compared)});
  }
  legend.lines.push_back("wrong: " + percent_text(e.wrongly_lit + e.wrongly_dark, e.compared) + "; lit " +
                         percent_text(e.wrongly_lit, e.compared) + ", dark " + percent_text(e.wrongly_dark, e.compared));
  if (view.lit_difference && *view.lit_difference != e.fraction())
    legend.lines.push_back("lit fraction: " + percent_text(*view.lit_difference) + " from the truth on average");
  return legend;
}

}  // namespace psm
