// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of the views: drawn again only where something they show has changed, and only while they are on screen.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "draw/view.h"
#include "gl/renderer.h"
#include "gl/traced_overlay.h"
#include "ui/layout.h"
#include "ui/model.h"
#include "ui/profile.h"

namespace psm {

/// Where an orbit that is left to the fit looks from: found once, so that the picture's camera stays where it is while the
/// experiment changes.
class FittedOrbits {
 public:
  /// The views with every orbit written out.
  ViewSettings shown(const Model& model, const ViewSizes& sizes);
  void fit_again() { world_.reset(), cube_.reset(), body_.reset(); }

 private:
  struct Fit {
    std::uint64_t scene = 0;
    double aspect = 0.0;
    glm::dvec3 asked{0.0};  // the target as the experiment has it
    OrbitSettings orbit;
  };
  static OrbitSettings fitted(std::optional<Fit>& fit, ViewId id, const OrbitSettings& asked, const Model& model, double aspect);
  std::optional<Fit> world_, cube_, body_;
};

using ShownParts = std::array<ShownPart, kAllViews.size()>;  // by ViewId

class ViewImages {
 public:
  explicit ViewImages(Renderer& renderer) : renderer_(renderer) {}

  /// Draws what is out of date; returns how many views were drawn. `sizes`: empty (0) for hidden views.
  int update(const Model& model, const ViewSettings& shown, const ViewSizes& sizes, double scale, Theme theme, Profile& profile);
  /// From now on.
  void set_shown_parts(ShownParts parts) { parts_ = std::move(parts); }
  void set_emphasis(Emphasis emphasis) { emphasis_ = std::move(emphasis); }
  const Emphasis& emphasis() const { return emphasis_; }
  /// The card has this model's scene.
  bool has_scene_of(const Model& model) const { return scene_ == model.scene_revision(); }

  /// The eye view's overlay for this analysis, if it takes rays and they are not traced yet. Takes tens of
  /// milliseconds.
  void trace_overlay(const Model& model, Profile& profile);

  const ViewPicture& picture(ViewId id) const { return views_[std::size_t(id)].picture; }
  std::uint32_t texture(ViewId id) const { return views_[std::size_t(id)].texture; }
  glm::ivec2 size(ViewId id) const { return views_[std::size_t(id)].key.size; }
  const Analysis& analysis() const { return analysis_; }  // with the views as shown

 private:
  struct Key {
    std::uint64_t analysis = 0;
    ViewSettings view;  // only what this view depends on
    glm::ivec2 size{0};
    double scale = 0.0;
    Theme theme = Theme::light;
    std::uint64_t traced = 0;  // the analysis whose traced overlay is shown
    std::uint64_t texels = 0;  // the statistics that the legend shows
    Emphasis emphasis;
    ShownPart part;
    bool operator==(const Key&) const = default;
  };
  struct View {
    Key key;
    ViewPicture picture;
    std::uint32_t texture = 0;
  };
  void upload(const Model& model, Profile& profile);
  bool is_traced(const Model& model, EyeOverlay overlay) const;

  Renderer& renderer_;
  Analysis analysis_;
  Emphasis emphasis_;
  ShownParts parts_;
  std::optional<TracedOverlay> traced_;
  EyeOverlay traced_kind_ = EyeOverlay::none;
  std::uint64_t traced_of_ = 0;  // analysis revision
  std::uint64_t scene_ = 0, map_ = 0, known_texels_ = 0;
  std::array<View, kAllViews.size()> views_;
};

}  // namespace psm
