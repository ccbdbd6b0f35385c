// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view_images.h"

#include <utility>

#include "draw/texel_overlay.h"
#include "ui/navigation.h"

namespace psm {
namespace {

/// What the picture of this view depends on; the rest at its defaults.
ViewSettings relevant(ViewId id, const ViewSettings& view) {
  ViewSettings out;
  if (id == ViewId::world) out.world = view.world, out.world_body = view.world_body;
  if (id == ViewId::cube) out.cube = view.cube, out.world_to_cube = view.world_to_cube;
  if (id == ViewId::map) out.map_center = view.map_center, out.map_zoom = view.map_zoom, out.map_shows = view.map_shows;
  if (id == ViewId::eye) out.eye_overlay = view.eye_overlay;
  if (id == ViewId::body) out.body = view.body;
  if (id == ViewId::curves) out.curve = view.curve, out.curve_range = view.curve_range;
  if (id == ViewId::explorer) out.explorer_slice = view.explorer_slice;
  if (id == ViewId::world || id == ViewId::cube || id == ViewId::eye) out.texel_grid = view.texel_grid;
  return out;
}

/// Drawn from the analysis alone: neither the scene nor the shadow map is needed.
bool is_drawing(ViewId id) { return id == ViewId::body || id == ViewId::curves || id == ViewId::explorer; }

double aspect_of_size(glm::ivec2 size) { return size.x > 0 && size.y > 0 ? double(size.x) / size.y : 1.0; }

}  // namespace

OrbitSettings FittedOrbits::fitted(std::optional<Fit>& fit, ViewId id, const OrbitSettings& asked, const Model& model,
                                   double aspect) {
  if (asked.distance > 0.0) return asked;
  if (!fit || fit->scene != model.scene_revision() || fit->aspect != aspect || fit->asked != asked.target)
    fit = {model.scene_revision(), aspect, asked.target, resolved(asked, view_camera(id, model.analysis(), aspect))};
  OrbitSettings out = fit->orbit;
  out.yaw_deg = asked.yaw_deg, out.pitch_deg = asked.pitch_deg;
  return out;
}

ViewSettings FittedOrbits::shown(const Model& model, const ViewSizes& sizes) {
  ViewSettings view = model.experiment().view;
  const auto size = [&](ViewId id) { return sizes[std::size_t(id)]; };
  // A hidden view keeps the fit it had.
  if (size(ViewId::world).x > 0)
    view.world = fitted(world_, ViewId::world, view.world, model, aspect_of_size(size(ViewId::world)));
  if (size(ViewId::cube).x > 0) view.cube = fitted(cube_, ViewId::cube, view.cube, model, aspect_of_size(size(ViewId::cube)));
  if (size(ViewId::body).x > 0) view.body = fitted(body_, ViewId::body, view.body, model, aspect_of_size(size(ViewId::body)));
  return view;
}

void ViewImages::upload(const Model& model, Profile& profile) {
  const bool new_scene = scene_ != model.scene_revision();
  if (new_scene) profile.run(Stage::scene, [&] { renderer_.set_scene(model.scene()); });
  if (new_scene || map_ != model.analysis_revision()) {
    const int maps_before = renderer_.maps_drawn();
    profile.run(Stage::map, [&] { renderer_.update_shadow_map(model.analysis()); });
    if (renderer_.map_triangles() == 0)
      profile.skipped(Stage::map, "no caster reaches a receiver");
    else if (renderer_.maps_drawn() == maps_before)
      profile.skipped(Stage::map, "unchanged: it would come out as it is");
  }
  scene_ = model.scene_revision();
  map_ = model.analysis_revision();
}

void ViewImages::trace_overlay(const Model& model, Profile& profile) {
  const EyeOverlay overlay = model.experiment().view.eye_overlay;
  if (!takes_rays(overlay)) return profile.skipped(Stage::truth, "the eye view shows nothing that takes rays");
  if (is_traced(model, overlay)) return;
  upload(model, profile);
  profile.run(Stage::truth, [&] {
    Analysis analysis = model.analysis();
    analysis.experiment.view = model.experiment().view;
    traced_ = psm::trace_overlay(renderer_, model.tracer(), analysis, quick_pixels(analysis.experiment.light));
  });
  traced_kind_ = overlay;
  traced_of_ = model.analysis_revision();
}

bool ViewImages::is_traced(const Model& model, EyeOverlay overlay) const {
  return traced_ && traced_kind_ == overlay && traced_of_ == model.analysis_revision();
}

int ViewImages::update(const Model& model, const ViewSettings& shown, const ViewSizes& sizes, double scale, Theme theme,
                       Profile& profile) {
  if (std::exchange(known_texels_, model.texels_revision()) != model.texels_revision()) analysis_ = model.analysis();
  analysis_.experiment.view = shown;
  int drawn = 0;
  for (ViewId id : kAllViews) {
    const glm::ivec2 size = sizes[std::size_t(id)];
    if (size.x <= 0 || size.y <= 0) {
      profile.skipped(stage_of(id), "hidden");
      continue;
    }
    View& view = views_[std::size_t(id)];
    const bool has_rays = id == ViewId::eye && is_traced(model, shown.eye_overlay);
    const bool shows_texels = id == ViewId::eye && heat_scale(shown.eye_overlay);
    const Key key{model.analysis_revision(),
                  relevant(id, shown),
                  size,
                  scale,
                  theme,
                  has_rays ? traced_of_ : 0,
                  shows_texels ? model.texels_revision() : 0,
                  emphasis_,
                  parts_[std::size_t(id)]};
    if (view.texture != 0 && view.key == key) continue;
    if (!is_drawing(id)) upload(model, profile);
    profile.run(stage_of(id), [&] {
      const ViewExtras extras{emphasis_, nullptr, has_rays ? &*traced_ : nullptr, parts_[std::size_t(id)]};
      view.picture = describe_view(id, analysis_, size, scale, extras);
      view.texture = renderer_.draw_view(view.picture, analysis_, size, scale, theme);
    });
    view.key = key;
    ++drawn;
  }
  return drawn;
}

}  // namespace psm
