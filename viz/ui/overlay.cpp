// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/overlay.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "draw/annotation.h"
#include "draw/split_at_infinity.h"
#include "ui/theme.h"

namespace psm {
namespace {

constexpr double kTextSize = 16.0, kHalo = 2.0, kDash = 6.0, kGap = 4.0, kArrow = 11.0;  // pixels at scale 1

class Overlay {
 public:
  Overlay(const UiContext& ui, const ViewPicture& under, const Rect& picture)
      : ui_(ui), under_(under), picture_(picture), to_(ImGui::GetWindowDrawList()) {}

  void fill(const DrawFill& f) const {
    std::vector<ImVec2> corners;
    for (const glm::dvec4& corner : f.corners) {
      const glm::dvec4 q = under_.clip_from_list * corner;
      if (!(q.w > 0.0)) return;
      corners.push_back(screen(glm::dvec2(q) / q.w));
    }
    to_->AddConvexPolyFilled(corners.data(), int(corners.size()), color(role_color(f.role), f.alpha));
  }

  void line(const DrawLine& l) const {
    const Box near_picture{{-1.2, -1.2, -1e9}, {1.2, 1.2, 1e9}};
    const auto piece = clip_segment(under_.clip_from_list * l.a, under_.clip_from_list * l.b, near_picture);
    if (!piece) return;
    const ImVec2 a = screen(glm::dvec2(piece->a)), b = screen(glm::dvec2(piece->b));
    stroke(a, b, l, float((l.width + kHalo) * ui_.scale), color(ground_color(ui_.theme), 0.55));
    stroke(a, b, l, float(l.width * ui_.scale), line_color(l.role, ui_.theme));
    if (l.arrow && !piece->cut_b) head(a, b, line_color(l.role, ui_.theme));
  }

  void point(const DrawPoint& p) const {
    const glm::dvec4 q = under_.clip_from_list * p.position;
    if (!(q.w > 0.0)) return;
    const ImVec2 at = screen(glm::dvec2(q) / q.w);
    const float radius = float(p.radius * ui_.scale);
    to_->AddCircleFilled(at, radius + float(1.5 * ui_.scale), color(ground_color(ui_.theme)), 24);
    to_->AddCircleFilled(at, radius, line_color(p.role, ui_.theme), 24);
  }

  void labels(const DrawList& list) const {
    TextSize text_size = [px = text_px()](const std::string& text) {
      const ImVec2 size = ImGui::GetFont()->CalcTextSizeA(px, 1e9f, 0.0f, text.c_str());
      return glm::dvec2(size.x, size.y);
    };
    std::vector<Occupied> taken;
    for (const Plate& plate : annotate(under_, {picture_.size(), ui_.scale, ui_.theme}, text_size).plates)
      taken.push_back({plate.top_left, plate.size});
    for (const Occupied& part : under_.shown.covered)
      taken.push_back({part.top_left * glm::dvec2(picture_.size()), part.size * glm::dvec2(picture_.size())});
    const auto measure = [](const std::string& text, double, void* size) { return (*static_cast<const TextSize*>(size))(text); };
    for (const PlacedLabel& label :
         place_labels(list, under_.clip_from_list, picture_.size(), ui_.scale, measure, &text_size, taken, under_.shown.columns))
      draw(label);
  }

 private:
  float text_px() const { return float(std::max(8.0, std::round(kTextSize * ui_.scale))); }
  double margin() const { return label_margin * ui_.scale; }
  ImVec2 at_pixel(glm::dvec2 p) const { return {float(picture_.min.x + p.x), float(picture_.min.y + p.y)}; }
  ImVec2 screen(glm::dvec2 ndc) const {
    const glm::dvec2 size = picture_.size();
    return at_pixel({0.5 * (1.0 + ndc.x) * size.x, 0.5 * (1.0 - ndc.y) * size.y});
  }

  void draw(const PlacedLabel& label) const {
    const glm::dvec2 low = label.top_left - margin(), high = label.top_left + label.size + margin();
    const Color ink = label_color(label.role);
    if (label.leader) to_->AddLine(at_pixel(glm::clamp(label.anchor, low, high)), at_pixel(label.anchor), ink, float(ui_.scale));
    to_->AddRectFilled(at_pixel(low), at_pixel(high), color(ground_color(ui_.theme), 0.9), float(margin()));
    to_->AddRect(at_pixel(low), at_pixel(high), color(line_tone(label.role), 0.6), float(margin()), 0, float(ui_.scale));
    to_->AddText(ImGui::GetFont(), text_px(), at_pixel(label.top_left), ink, label.text.c_str());
  }
  glm::vec3 line_tone(Role role) const { return ui_.theme == Theme::light ? role_line_color(role) : role_color(role); }
  Color label_color(Role role) const {
    return ui_.theme == Theme::light ? color(role_text_color(role)) : color(glm::mix(role_color(role), glm::vec3(1.0f), 0.35f));
  }

  void stroke(ImVec2 a, ImVec2 b, const DrawLine& l, float width, Color ink) const {
    if (l.style == LineStyle::solid) return to_->AddLine(a, b, ink, width);
    const glm::dvec2 from(a.x, a.y), to(b.x, b.y);
    const double length = glm::length(to - from), period = (kDash + kGap) * ui_.scale;
    for (double t = 0.0; t < length; t += period) {
      const glm::dvec2 p = glm::mix(from, to, t / length),
                       q = glm::mix(from, to, std::min(1.0, (t + kDash * ui_.scale) / length));
      to_->AddLine({float(p.x), float(p.y)}, {float(q.x), float(q.y)}, ink, width);
    }
  }

  void head(ImVec2 a, ImVec2 b, Color ink) const {
    const glm::dvec2 tip(b.x, b.y), way = tip - glm::dvec2(a.x, a.y);
    const double length = glm::length(way);
    if (!(length > 1.0)) return;
    const glm::dvec2 back = tip - way / length * kArrow * ui_.scale, aside = 0.38 * glm::dvec2(tip.y - back.y, back.x - tip.x);
    const auto vec = [](glm::dvec2 p) { return ImVec2(float(p.x), float(p.y)); };
    to_->AddTriangleFilled(b, vec(back + aside), vec(back - aside), ink);
  }

  const UiContext& ui_;
  const ViewPicture& under_;
  Rect picture_;
  ImDrawList* to_;
};

}  // namespace

void draw_over(const UiContext& ui, const DrawList& list, const ViewPicture& under, const Rect& picture) {
  const Overlay overlay(ui, under, picture);
  ImDrawList* to = ImGui::GetWindowDrawList();
  to->PushClipRect({float(picture.min.x), float(picture.min.y)}, {float(picture.max.x), float(picture.max.y)}, true);
  for (const DrawFill& fill : list.fills) overlay.fill(fill);
  for (const DrawLine& line : list.lines) overlay.line(line);
  for (const DrawPoint& point : list.points) overlay.point(point);
  overlay.labels(list);
  to->PopClipRect();
}

}  // namespace psm
