// SPDX-License-Identifier: GPL-3.0-or-later
// Greedy label placement after Stein and Decoret (2008): the label with the fewest free places goes first, to its cheapest place.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "draw/draw_list.h"
#include "draw/split_at_infinity.h"

namespace psm {
namespace {

constexpr std::size_t most_labels = 12;
constexpr std::array<double, 3> rings{14.0, 32.0, 60.0};  // pixels at scale 1 from the anchor to the text's box

struct Rect {
  glm::dvec2 min, max;
  Rect grown(double by) const { return {min - by, max + by}; }
  bool overlaps(const Rect& r) const { return min.x < r.max.x && r.min.x < max.x && min.y < r.max.y && r.min.y < max.y; }
  bool contains(const glm::dvec2& p) const { return p.x > min.x && p.x < max.x && p.y > min.y && p.y < max.y; }
  bool inside(const Rect& r) const { return min.x >= r.min.x && min.y >= r.min.y && max.x <= r.max.x && max.y <= r.max.y; }
  glm::dvec2 nearest(const glm::dvec2& p) const { return glm::clamp(p, min, max); }
};

struct Segment2 {
  glm::dvec2 a, b;
  Rect box() const { return {glm::min(a, b), glm::max(a, b)}; }
};

struct Candidate {
  Rect text;
  double distance = 0.0;  // from anchor to text, pixels at scale 1
};

struct Pending {
  const DrawLabel* label = nullptr;
  glm::dvec2 anchor{0.0}, size{0.0};
  std::vector<Candidate> free;
};

double side_of(const Segment2& s, const glm::dvec2& p) {
  return (s.b.x - s.a.x) * (p.y - s.a.y) - (s.b.y - s.a.y) * (p.x - s.a.x);
}

bool crosses(const Segment2& s, const Segment2& t) {
  return side_of(s, t.a) * side_of(s, t.b) < 0.0 && side_of(t, s.a) * side_of(t, s.b) < 0.0;
}

bool crosses(const Segment2& s, const Rect& r) {
  return r.contains(s.a) || r.contains(s.b) || crosses(s, Segment2{r.min, r.max}) ||
         crosses(s, Segment2{{r.min.x, r.max.y}, {r.max.x, r.min.y}});
}

glm::dvec2 to_pixels(const glm::dvec2& ndc, const glm::dvec2& picture) {
  return {0.5 * (1.0 + ndc.x) * picture.x, 0.5 * (1.0 - ndc.y) * picture.y};
}

/// Where the anchor is on the picture; none behind the viewer or outside.
std::optional<glm::dvec2> project_anchor(const glm::dvec4& clip, const glm::dvec2& picture) {
  if (!(clip.w > 0.0)) return std::nullopt;
  const glm::dvec2 ndc = glm::dvec2(clip) / clip.w;
  if (!(std::abs(ndc.x) <= 1.0 && std::abs(ndc.y) <= 1.0)) return std::nullopt;
  return to_pixels(ndc, picture);
}

std::vector<Segment2> project_lines(const DrawList& list, const glm::dmat4& clip_from_list, const glm::dvec2& picture) {
  const Box on_screen{{-1.0, -1.0, -1e9}, {1.0, 1.0, 1e9}};
  std::vector<Segment2> segments;
  for (const DrawLine& line : list.lines) {
    const auto piece = clip_segment(clip_from_list * line.a, clip_from_list * line.b, on_screen);
    if (piece) segments.push_back({to_pixels(piece->a, picture), to_pixels(piece->b, picture)});
  }
  return segments;
}

std::vector<Candidate> candidates(const glm::dvec2& anchor, const glm::dvec2& size, double scale) {
  std::vector<Candidate> result;
  for (double ring : rings) {
    for (int direction = 0; direction < 8; ++direction) {
      const double angle = direction * glm::radians(45.0);
      const glm::dvec2 d(std::cos(angle), -std::sin(angle));
      const glm::dvec2 side(std::round(d.x), std::round(d.y));
      const glm::dvec2 center = anchor + ring * scale * d + 0.5 * size * side;
      result.push_back({{center - 0.5 * size, center + 0.5 * size}, ring});
    }
  }
  return result;
}

class Placer {
 public:
  Placer(const DrawList& list, const glm::dmat4& clip_from_list, const glm::dvec2& picture, const glm::dvec2& columns,
         double scale)
      : shown_{{columns.x * picture.x, 0.0}, {columns.y * picture.x, picture.y}},
        scale_(scale),
        lines_(project_lines(list, clip_from_list, picture)) {}

  void keep_free(const Rect& taken) { taken_.push_back(taken); }

  void add(const DrawLabel& label, const glm::dvec2& anchor, const glm::dvec2& size) {
    if (anchor.x < shown_.min.x || anchor.x > shown_.max.x) return;
    anchors_.push_back(anchor);
    Pending pending{&label, anchor, size, candidates(anchor, size, scale_)};
    std::erase_if(pending.free, [&](const Candidate& c) { return !may_stand(c.text.grown(margin())); });
    pending_.push_back(std::move(pending));
  }

  std::vector<PlacedLabel> place() {
    while (placed_.size() < most_labels) {
      std::erase_if(pending_, [](const Pending& p) { return p.free.empty(); });
      if (pending_.empty()) break;
      const auto next = std::min_element(pending_.begin(), pending_.end(), [](const Pending& p, const Pending& q) {
        if (p.label->priority != q.label->priority) return p.label->priority > q.label->priority;
        return p.free.size() < q.free.size();
      });
      const Pending chosen = std::move(*next);
      pending_.erase(next);
      put(chosen);
    }
    return std::move(placed_);
  }

 private:
  double margin() const { return label_margin * scale_; }

  bool may_stand(const Rect& plate) const {
    return plate.inside(shown_) && std::none_of(taken_.begin(), taken_.end(), [&](const Rect& t) { return t.overlaps(plate); });
  }

  /// Leader length, lines covered and crossed, anchors covered. In units of the nearest ring's leader.
  double cost(const Pending& pending, const Candidate& candidate) const {
    const Rect plate = candidate.text.grown(margin());
    const Segment2 leader{pending.anchor, plate.nearest(pending.anchor)};
    double sum = candidate.distance / rings[0];
    const Rect reach{glm::min(plate.min, pending.anchor), glm::max(plate.max, pending.anchor)};
    for (const Segment2& line : lines_)
      if (reach.overlaps(line.box())) sum += 0.9 * crosses(line, plate) + 0.15 * crosses(line, leader);
    for (const Segment2& other : leaders_) sum += 6.0 * crosses(other, leader) + 6.0 * crosses(other, plate);
    for (const glm::dvec2& other : anchors_) sum += 2.0 * (other != pending.anchor && plate.contains(other));
    for (const Rect& other : plates_) sum += 6.0 * crosses(leader, other);
    return sum;
  }

  void put(const Pending& chosen) {
    std::vector<double> costs;
    for (const Candidate& candidate : chosen.free) costs.push_back(cost(chosen, candidate));
    const auto best = chosen.free.begin() + (std::min_element(costs.begin(), costs.end()) - costs.begin());
    const Rect plate = best->text.grown(margin());
    placed_.push_back(
        {best->text.min, chosen.size, chosen.anchor, chosen.label->text, chosen.label->role, best->distance > rings[0]});
    leaders_.push_back({chosen.anchor, plate.nearest(chosen.anchor)});
    plates_.push_back(plate);
    for (Pending& p : pending_) {
      std::erase_if(p.free, [&](const Candidate& c) { return c.text.grown(margin()).overlaps(plate); });
    }
  }

  Rect shown_;
  double scale_;
  std::vector<Segment2> lines_, leaders_;
  std::vector<Rect> taken_, plates_;
  std::vector<glm::dvec2> anchors_;
  std::vector<Pending> pending_;
  std::vector<PlacedLabel> placed_;
};

}  // namespace

std::vector<PlacedLabel> place_labels(const DrawList& list, const glm::dmat4& clip_from_list, glm::dvec2 picture_size,
                                      double scale, glm::dvec2 (*text_size)(const std::string&, double scale, void*),
                                      void* context, const std::vector<Occupied>& occupied, const glm::dvec2& columns) {
  Placer placer(list, clip_from_list, picture_size, columns, scale);
  for (const Occupied& o : occupied) placer.keep_free({o.top_left, o.top_left + o.size});
  for (const DrawLabel& label : list.labels) {
    if (label.text.empty()) continue;
    const auto anchor = project_anchor(clip_from_list * label.anchor, picture_size);
    if (anchor) placer.add(label, *anchor, text_size(label.text, scale, context));
  }
  return placer.place();
}

}  // namespace psm
