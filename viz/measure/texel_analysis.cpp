// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/texel_analysis.h"

#include <algorithm>

#include "measure/shadow_error.h"

namespace psm {
namespace {

/// What analyze() estimates from a coarse grid, decided by all pixels.
void compare_with_uniform(Analysis& analysis, double p95_of_uniform) {
  const auto estimate = [](const Note& n) { return n.code == "worse_than_uniform_texels"; };
  auto& notes = analysis.notes;
  notes.erase(std::remove_if(notes.begin(), notes.end(), estimate), notes.end());
  const bool in_model = std::any_of(notes.begin(), notes.end(), [](const Note& n) { return n.code == "worse_than_uniform"; });
  const bool worse = analysis.texels->m_p95 > p95_of_uniform * (1 + 1e-9);
  analysis.worse_than_uniform = worse || in_model;
  if (worse)
    notes.push_back({"worse_than_uniform_texels",
                     "Worse than the uniform map: 95th percentile of the texel size m in pixels, over all visible pixels that "
                     "face the light.",
                     analysis.texels->m_p95, p95_of_uniform});
}

}  // namespace

void count_texels(Analysis& analysis, const Scene& scene, const RayTracer& tracer, const VisibleImage& image) {
  analysis.texels = texel_statistics(texel_sizes(image, analysis));
  if (!analysis.texels) {
    analysis.notes.push_back(
        {"texels_none", "No pixel shows a surface that faces the light: there are no texel sizes.", std::nullopt, std::nullopt});
  } else if (analysis.technique_used != Technique::uniform) {
    Experiment uniform = analysis.experiment;
    uniform.shadow.technique = Technique::uniform;
    compare_with_uniform(analysis, texel_statistics(texel_sizes(image, analyze(uniform, scene, tracer)))->m_p95);
  }
}

Analysis analyze_with_texels(const Experiment& experiment, const Scene& scene) {
  const RayTracer tracer(scene);
  Analysis analysis = analyze(experiment, scene, tracer);
  count_texels(analysis, scene, tracer, see(tracer, experiment, experiment.image.width, experiment.image.height));
  return analysis;
}

}  // namespace psm
