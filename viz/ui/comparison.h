// SPDX-License-Identifier: GPL-3.0-or-later
// A and B: the experiment with a second technique, shown in the same views by the same cameras.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <string>

#include "ui/ui_context.h"
#include "ui/view_images.h"
#include "ui/view_tile.h"

namespace psm {

using ViewRects = std::array<Rect, kAllViews.size()>;  // by ViewId

/// The views that both techniques share. The cube and the body stay A's.
constexpr bool is_compared(ViewId id) { return id == ViewId::eye || id == ViewId::world || id == ViewId::map; }

/// Whether a line divides this view; else the two pictures stand side by side. Half of one map beside half of another would say
/// nothing: the same place means something else in each.
bool is_split(ViewId id, const ViewSettings& view);

/// Where B's pictures go, by view; empty: nowhere. Side by side, A's rectangle in `layout` becomes its left half.
ViewRects place_second(Layout& layout, const ViewSettings& view, int gap);

/// What of a view's picture is A's.
Rect first_part(ViewId id, const Rect& picture, const ViewSettings& view);

/// "A  GMNPR", what was used instead where it fell back, and the size of its texels where the eye view shows that.
std::string comparison_name(char letter, const Analysis& analysis);

/// B: an analysis, a shadow map and pictures of its own. Nothing of it exists while the experiment compares nothing.
class Comparison {
 public:
  Comparison(std::filesystem::path assets, std::filesystem::path font);
  ~Comparison();

  /// Goes where A has gone and draws what is out of date; returns how many views. `shown`: the cameras of A's pictures.
  int update(const Model& first, const ViewSettings& shown, const ViewRects& places, double scale, Theme theme,
             const Emphasis& emphasis, const ShownParts& parts, bool resting);

  /// Null while nothing is compared.
  const Analysis* analysis() const;
  const ViewImages* images() const;

 private:
  struct Second;
  std::filesystem::path assets_, font_;
  std::unique_ptr<Second> second_;
};

/// The mouse in B's pictures and on the lines between A and B; before A's own input, whose names the places keep. As tile_input.
std::string second_input(UiContext& ui, const ViewRects& places, const ViewImages* images, ViewDrag& drag,
                         Experiment& experiment);

/// What the line and the names leave of both's pictures.
struct ComparedParts {
  ShownParts first, second;
  bool operator==(const ComparedParts&) const = default;
};

/// B's pictures, where they are not A's, with the lines and both names; after A's pictures.
ComparedParts draw_seconds(UiContext& ui, const Layout& layout, const ViewRects& places, const ViewImages& first_images,
                           const ViewImages* images, const ViewDrag& drag);

}  // namespace psm
