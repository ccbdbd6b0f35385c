// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "draw/probe.h"
#include "draw/sketch.h"
#include "draw/texel_overlay.h"

namespace psm {
namespace {

bool drawable(const glm::dvec4& q) { return q.w > 0.0 && std::isfinite(q.x + q.y + q.z + q.w); }

bool drawable(const DrawFill& fill) {
  for (const glm::dvec4& corner : fill.corners) {
    if (!drawable(corner)) return false;
  }
  return fill.corners.size() >= 3;
}

/// Coordinates near the end of the number range overflow somewhere; what did is left out rather than drawn wrongly.
void drop_overflow(DrawList& list) {
  std::erase_if(list.lines, [](const DrawLine& line) { return !drawable(line.a) || !drawable(line.b); });
  std::erase_if(list.fills, [](const DrawFill& fill) { return !drawable(fill); });
  std::erase_if(list.points, [](const DrawPoint& point) { return !drawable(point.position); });
  std::erase_if(list.texts, [](const DrawText& text) { return !drawable(text.position); });
  std::erase_if(list.labels, [](const DrawLabel& label) { return !drawable(label.anchor); });
}

/// `page`: the size in pixels at scale 1.
ViewPicture describe(ViewId id, const Analysis& analysis, glm::ivec2 size, const glm::dvec2& page) {
  switch (id) {
    case ViewId::world:
      return describe_world(analysis, size);
    case ViewId::cube:
      return describe_cube(analysis, size);
    case ViewId::map:
      return describe_map(analysis, size);
    case ViewId::eye:
      return describe_eye(analysis, size);
    case ViewId::body:
      return describe_body(analysis, size);
    case ViewId::curves:
      return describe_curves(analysis, page);
    case ViewId::explorer:
      return describe_explorer(analysis, page);
  }
  return {};
}

/// Over the eye view, or in its legend's place until it is there.
void show_traced(const TracedOverlay* traced, ViewPicture& eye) {
  if (!traced) return eye.legend.lines.push_back("traced when nothing moves");
  eye.cover = traced->image;
  eye.texel_step = 0;  // under the cover
  eye.legend = traced->legend;
}

}  // namespace

bool takes_rays(EyeOverlay overlay) { return overlay == EyeOverlay::errors || overlay == EyeOverlay::penumbra; }

double aspect_of(glm::ivec2 size) { return size.x > 0 && size.y > 0 ? double(size.x) / size.y : 1.0; }

std::string map_remark(const Analysis& analysis) {
  const Technique asked = analysis.experiment.shadow.technique, used = analysis.technique_used;
  const std::string other = used == asked ? "" : std::string(", not ") + name_of(asked);
  if (analysis.cube_maps_from_world) return other + ": light in R";
  return other.empty() || analysis.receivers_body.empty() ? "" : std::string(", ") + name_of(used) + other;
}

ViewPicture describe_view(ViewId id, const Analysis& analysis, glm::ivec2 size, double scale, const ViewExtras& extras) {
  ViewPicture picture = describe(id, analysis, size, glm::dvec2(glm::max(size, glm::ivec2(1))) / scale);
  add_texel_overlay(picture, analysis, size);
  if (id == ViewId::map && analysis.experiment.view.map_shows == MapShows::scene) show_scene_in_map(picture, analysis);
  if (id == ViewId::eye && takes_rays(analysis.experiment.view.eye_overlay)) show_traced(extras.traced, picture);
  picture.shown = extras.shown;
  if (picture.shown.divided()) picture.legend.lines.clear();
  emphasise(picture.list, extras.emphasis);
  if (extras.probe) {
    DrawList probe = probe_list(*extras.probe, id, analysis, size);
    remove(probe, extras.emphasis.hidden);
    append(picture.list, std::move(probe));
  }
  drop_overflow(picture.list);
  return picture;
}

}  // namespace psm
