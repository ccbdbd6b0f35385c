// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/probe_hover.h"

#include <cmath>
#include <limits>

#include "measure/pick.h"
#include "ui/overlay.h"

namespace psm {
namespace {

/// The point at the pixel, in the space of the view's list.
glm::dvec4 list_point(const PointedAt& at, const ViewImages& images, double depth) {
  const glm::dvec2 size = images.size(at.view);
  const glm::dvec4 clip(2.0 * at.pixel.x / size.x - 1.0, 1.0 - 2.0 * at.pixel.y / size.y, depth, 1.0);
  return glm::inverse(images.picture(at.view).clip_from_list) * clip;
}

std::optional<Pick> pick_in_world(const PointedAt& at, const Model& model, const ViewImages& images) {
  const glm::dvec4 near = list_point(at, images, -1.0), far = list_point(at, images, 1.0);
  const glm::dvec3 start = glm::dvec3(near) / near.w;
  return pick_ray(model.tracer(), model.analysis(), start, glm::dvec3(far) / far.w - start, 0.0,
                  std::numeric_limits<double>::infinity());
}

std::optional<Pick> pick_in_map(const PointedAt& at, const Model& model, const ViewImages& images) {
  const glm::dvec4 p = list_point(at, images, 0.0);
  const auto found = on_map(model.analysis(), glm::dvec2(p) / p.w);
  return found ? pick_texel(model.tracer(), model.analysis(), found->layer, found->center) : std::nullopt;
}

std::optional<Probe> probe_from(const std::optional<Pick>& pick, const Analysis& analysis) {
  return pick ? make_probe(analysis, pick->receiver, pick->occluder, pick->seen) : std::nullopt;
}

}  // namespace

std::optional<glm::dvec2> image_pixel(const PointedAt& at, const ViewImages& images) {
  const glm::dvec4 p = list_point(at, images, 0.0);
  const glm::dvec2 ndc = glm::dvec2(p) / p.w;
  if (!(std::abs(ndc.x) < 1.0 && std::abs(ndc.y) < 1.0)) return std::nullopt;
  const ImageSettings& image = images.analysis().experiment.image;
  return glm::dvec2(0.5 * (1.0 + ndc.x) * image.width, 0.5 * (1.0 - ndc.y) * image.height);
}

std::optional<Probe> probe_under(const PointedAt& at, const Model& model, const ViewImages& images) {
  if (images.texture(at.view) == 0) return std::nullopt;
  switch (at.view) {
    case ViewId::eye:
      return probe_at(image_pixel(at, images), model.tracer(), model.analysis());
    case ViewId::world:
      return probe_from(pick_in_world(at, model, images), model.analysis());
    case ViewId::map:
      return probe_from(pick_in_map(at, model, images), model.analysis());
    case ViewId::cube:
    case ViewId::body:
    case ViewId::curves:
    case ViewId::explorer:
      return std::nullopt;
  }
  return std::nullopt;
}

std::optional<Probe> probe_at(const std::optional<glm::dvec2>& pixel, const RayTracer& tracer, const Analysis& analysis) {
  return pixel ? probe_from(pick_pixel(tracer, analysis, *pixel), analysis) : std::nullopt;
}

void draw_probe(const UiContext& ui, const Probe& probe, ViewId id, const Rect& picture, const ViewImages& images) {
  if (picture.empty() || images.texture(id) == 0) return;
  DrawList list = probe_list(probe, id, images.analysis(), picture.size());
  remove(list, images.emphasis().hidden);
  draw_over(ui, list, images.picture(id), picture);
}

}  // namespace psm
