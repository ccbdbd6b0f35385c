// SPDX-License-Identifier: GPL-3.0-or-later
#include "figure/view_panel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "draw/split_at_infinity.h"
#include "draw/stroke.h"

namespace psm {
namespace {

constexpr double kShortestRun = 3.0;   // pixels: shorter changes between seen and hidden are noise of the depth's rounding
constexpr double kArrowOverlap = 0.5;  // pixels that a line reaches into its head, so that no seam shows

/// The depth of the scene in the frame's pixels, which count upwards.
class SceneDepth {
 public:
  SceneDepth(const ViewRaster& raster, const PictureFrame& frame)
      : raster_(raster), pixels_(glm::dvec2(raster.image.width, raster.image.height) / frame.size) {}

  /// `depth`: normalised device coordinates.
  bool hides(const glm::dvec2& at, double depth) const {
    const int x = int(std::floor(at.x * pixels_.x)), y = raster_.image.height - 1 - int(std::floor(at.y * pixels_.y));
    if (x < 0 || y < 0 || x >= raster_.image.width || y >= raster_.image.height || raster_.depth.empty()) return false;
    return 0.5 * depth + 0.5 > raster_.depth[std::size_t(y) * raster_.image.width + x];
  }
  double pixels_per_unit() const { return std::max(pixels_.x, pixels_.y); }

 private:
  const ViewRaster& raster_;
  glm::dvec2 pixels_;
};

/// A stretch of a segment, as parts of it, that is seen as a whole or hidden as a whole.
struct Run {
  double from, to;
  bool hidden;
};

std::vector<Run> runs_of(const Stroke& stroke, const SceneDepth& scene) {
  const double length = glm::distance(stroke.a, stroke.b);
  const int steps = std::max(1, int(std::ceil(length * scene.pixels_per_unit())));
  std::vector<Run> runs;
  for (int i = 0; i < steps; ++i) {
    const double t = (i + 0.5) / steps;
    const bool hidden = scene.hides(glm::mix(stroke.a, stroke.b, t), glm::mix(stroke.depth_a, stroke.depth_b, t));
    if (runs.empty() || runs.back().hidden != hidden) runs.push_back({double(i) / steps, double(i) / steps, hidden});
    runs.back().to = double(i + 1) / steps;
  }
  // What is too short goes to the stretch before it, and that to what follows where the two agree now.
  std::vector<Run> smooth;
  for (const Run& run : runs) {
    const bool is_short = (run.to - run.from) * length < kShortestRun && runs.size() > 1;
    if (!smooth.empty() && (is_short || smooth.back().hidden == run.hidden))
      smooth.back().to = run.to;
    else
      smooth.push_back(run);
  }
  return smooth;
}

class PanelBuilder {
 public:
  PanelBuilder(const ViewPicture& picture, const PictureFrame& frame, const ViewRaster& raster, const glm::dvec2& top_left)
      : picture_(picture), frame_(frame), scene_(raster, frame), panel_{top_left, frame.size, {}} {}

  PagePanel take() { return std::move(panel_); }
  void add(PageItem item) { panel_.items.push_back(std::move(item)); }

  /// Far ones first.
  void fills(std::vector<PagePolygon> polygons, const std::vector<double>& depths) {
    std::vector<std::size_t> order(polygons.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return depths[i] > depths[j]; });
    for (const std::size_t i : order) add(std::move(polygons[i]));
  }

  /// The parts behind the scene, or those before it.
  void lines(Seen seen) {
    for (const DrawLine& line : picture_.list.lines) {
      const auto stroke = stroke_of(line, picture_.clip_from_list, frame_, seen);
      if (!stroke) continue;
      for (const Run& run : runs_of(*stroke, scene_))
        if (run.hidden == (seen == Seen::behind)) line_part(*stroke, run, picture_line_color(line.role, frame_.theme), seen);
    }
  }

  void points(Seen seen) {
    for (const DrawPoint& point : picture_.list.points) {
      const glm::dvec4 clip = picture_.clip_from_list * point.position;
      if (!finite(clip) || !(clip.w > 0.0) || std::abs(clip.z) > (1.0 + kPull) * clip.w) continue;
      const glm::dvec2 at = pixels_of(clip, frame_);
      const bool hidden = scene_.hides(at, pulled_depth(clip));
      if (hidden != (seen == Seen::behind)) continue;
      const float opacity = hidden ? float(kHiddenPointOpacity) : 1.0f;
      const double radius = point.radius * frame_.scale;
      const glm::vec3 rim(frame_.theme == Theme::light ? 0.1f : 0.95f);
      add(PageBox{on_page(at) - radius, glm::dvec2(2.0 * radius), radius, glm::vec4(role_color(point.role), opacity),
                  glm::vec4(rim, 0.85f * opacity), 1.25 * frame_.scale});
    }
  }

  void marks(const std::vector<Mark>& marks) {
    for (const Mark& m : marks)
      add(PageLine{m.a + panel_.top_left, m.b + panel_.top_left, glm::vec3(m.color), m.color.a, m.color.a, m.width});
  }

  void plates(const std::vector<Plate>& plates) {
    for (const Plate& p : plates) add(PageBox{p.top_left + panel_.top_left, p.size, p.radius, p.fill, p.rim, frame_.scale});
  }

  void texts(const std::vector<TextBox>& texts) {
    for (const TextBox& t : texts) add(PageText{t.top_left + panel_.top_left, t.size, t.text, t.color});
  }

  glm::dvec2 on_page(const glm::dvec2& upwards) const {
    return panel_.top_left + glm::dvec2(upwards.x, frame_.size.y - upwards.y);
  }

 private:
  void line_part(const Stroke& stroke, const Run& run, const glm::vec3& color, Seen seen) {
    PageLine line{on_page(glm::mix(stroke.a, stroke.b, run.from)), on_page(glm::mix(stroke.a, stroke.b, run.to)), color};
    line.opacity_a = glm::mix(stroke.opacity_a, stroke.opacity_b, run.from);
    line.opacity_b = glm::mix(stroke.opacity_a, stroke.opacity_b, run.to);
    line.width = stroke.width;
    const Dash dash = dash_of(seen);
    if (stroke.dashed) line.dash_on = dash.on * frame_.scale, line.dash_off = dash.off * frame_.scale;
    if (stroke.arrow && run.to == 1.0) arrow(line);
    add(line);
  }

  /// The head at the line's end, which then ends at the head's base.
  void arrow(PageLine& line) {
    const double length = glm::distance(line.a, line.b);
    if (!(length > 0.0)) return;
    const ArrowHead wanted = arrow_head(line.width, frame_.scale);
    const double shrink = std::min(1.0, length / wanted.length), head = wanted.length * shrink;
    const glm::dvec2 along = (line.b - line.a) / length, across(-along.y, along.x), base = line.b - head * along;
    const glm::dvec2 half = wanted.half_width * shrink * across;
    add(PagePolygon{{line.b, base + half, base - half}, glm::vec4(line.color, float(line.opacity_b))});
    line.b = base + std::min(kArrowOverlap, head) * along;
  }

  const ViewPicture& picture_;
  PictureFrame frame_;
  SceneDepth scene_;
  PagePanel panel_;
};

/// A fill on the picture: corners in pixels, y upwards, with their depths.
struct FlatFill {
  std::vector<glm::dvec2> corners;
  std::vector<double> depths;
  double mean_depth() const { return std::accumulate(depths.begin(), depths.end(), 0.0) / double(depths.size()); }
};

FlatFill flatten(const DrawFill& fill, const ViewPicture& picture, const PictureFrame& frame) {
  constexpr double kReach = 1.1;  // of the picture: what is cut off must not show
  std::vector<glm::dvec4> clip;
  for (const glm::dvec4& corner : fill.corners) clip.push_back(picture.clip_from_list * corner);
  FlatFill flat;
  for (const glm::dvec3& p : clip_polygon(clip, {{-kReach, -kReach, -1.0}, {kReach, kReach, 1.0}})) {
    flat.corners.push_back(pixels_of(glm::dvec4(p, 1.0), frame));
    flat.depths.push_back(p.z - kPull);
  }
  return flat;
}

/// Whether the scene hides the convex polygon at any of a grid of points within it. Depth is linear over each triangle of its
/// fan.
bool is_hidden(const FlatFill& flat, const SceneDepth& scene) {
  constexpr double kStep = 3.0;  // pixels
  for (std::size_t i = 2; i < flat.corners.size(); ++i) {
    const glm::dvec2 o = flat.corners[0], u = flat.corners[i - 1] - o, v = flat.corners[i] - o;
    const double du = flat.depths[i - 1] - flat.depths[0], dv = flat.depths[i] - flat.depths[0];
    const int n = int(std::ceil(std::max(glm::length(u), glm::length(v)) / kStep));
    for (int j = 1; j < n; ++j)
      for (int k = 1; j + k < n; ++k) {
        const double s = double(j) / n, t = double(k) / n;
        if (scene.hides(o + s * u + t * v, flat.depths[0] + s * du + t * dv)) return true;
      }
  }
  return false;
}

}  // namespace

std::vector<DrawFill> hidden_fills(const ViewPicture& picture, const PictureFrame& frame, const ViewRaster& raster) {
  const SceneDepth scene(raster, frame);
  std::vector<DrawFill> hidden;
  for (const DrawFill& fill : picture.list.fills)
    if (is_hidden(flatten(fill, picture, frame), scene)) hidden.push_back(fill);
  return hidden;
}

PagePanel view_panel(const ViewPicture& picture, const PictureFrame& frame, ViewRaster raster, const glm::dvec2& top_left,
                     const FontFace& font) {
  PanelBuilder builder(picture, frame, raster, top_left);
  std::vector<PagePolygon> polygons;
  std::vector<double> depths;
  const SceneDepth scene(raster, frame);
  for (const DrawFill& fill : picture.list.fills) {
    const FlatFill flat = flatten(fill, picture, frame);
    if (flat.corners.size() < 3 || is_hidden(flat, scene)) continue;
    polygons.push_back({{}, picture_fill(fill, frame.theme)});
    for (const glm::dvec2& corner : flat.corners) polygons.back().corners.push_back(builder.on_page(corner));
    depths.push_back(flat.mean_depth());
  }
  const Annotations notes =
      annotate(picture, frame, [&](const std::string& text) { return font.text_size(text, kTextHeight * frame.scale); });
  if (!raster.image.rgba.empty()) builder.add(PageImage{top_left, frame.size, raster.image});
  builder.fills(std::move(polygons), depths);
  builder.lines(Seen::behind);
  builder.lines(Seen::in_front);
  builder.marks(notes.leaders);
  builder.points(Seen::behind);
  builder.points(Seen::in_front);
  builder.plates(notes.plates);
  builder.marks(notes.marks);
  builder.texts(notes.texts);
  return builder.take();
}

}  // namespace psm
