// SPDX-License-Identifier: GPL-3.0-or-later
// Linked hovering: what the mouse points at in one view is shown in all of them. Drawn over the views' pictures, which stay as
// they are: no view is drawn again because the mouse moves.
#pragma once

#include <optional>

#include "draw/probe.h"
#include "ui/ui_context.h"
#include "ui/view_images.h"

namespace psm {

/// A pixel of a view's picture, y downwards.
struct PointedAt {
  ViewId view = ViewId::eye;
  glm::dvec2 pixel{0.0};
  bool operator==(const PointedAt&) const = default;
};

/// The probe at a pixel of the eye, world or map view; nothing over other views, or where there is no surface.
std::optional<Probe> probe_under(const PointedAt& at, const Model& model, const ViewImages& images);

/// The probe that the experiment itself asks for, if it does: at this pixel of its image.
std::optional<Probe> probe_at(const std::optional<glm::dvec2>& pixel, const RayTracer& tracer, const Analysis& analysis);

/// The pixel of the experiment's image under a pixel of the eye view; nothing beside the image.
std::optional<glm::dvec2> image_pixel(const PointedAt& at, const ViewImages& images);

/// The probe of this view, over its picture.
void draw_probe(const UiContext& ui, const Probe& probe, ViewId id, const Rect& picture, const ViewImages& images);

}  // namespace psm
