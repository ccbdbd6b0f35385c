// SPDX-License-Identifier: GPL-3.0-or-later
// A view as a panel of a page: the scene as a picture made of pixels, everything that explains it as lines, fills and text.
#pragma once

#include <vector>

#include "draw/annotation.h"
#include "draw/font_face.h"
#include "draw/view.h"
#include "figure/page.h"

namespace psm {

/// A view in pixels, as the renderer has it: rows top to bottom; the depth, in [0, 1], decides which parts of lines are hidden.
/// Empty for views that show no scene.
struct ViewRaster {
  Image image;
  std::vector<float> depth;  // as large as the image
};

/// The fills that the scene hides somewhere: only pixels can show them, so the renderer draws them into the image.
std::vector<DrawFill> hidden_fills(const ViewPicture& picture, const PictureFrame& frame, const ViewRaster& raster);

/// The panel, at `top_left` on the page. `raster.image` holds the scene and the hidden fills; the list's other fills, its lines
/// (the hidden parts thinner and dashed, as on screen), points, labels, the title and the legend are drawn here.
PagePanel view_panel(const ViewPicture& picture, const PictureFrame& frame, ViewRaster raster, const glm::dvec2& top_left,
                     const FontFace& font);

}  // namespace psm
