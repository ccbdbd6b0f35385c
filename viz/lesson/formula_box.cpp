// SPDX-License-Identifier: GPL-3.0-or-later
#include "lesson/formula_box.h"

#include <algorithm>
#include <cmath>

namespace psm {
namespace {

using Kind = Formula::Kind;
using Role = Formula::Role;

/// Sizes of a formula at one depth of scripts. Scripts are 0.7, and 0.5 within scripts, of the formula's own size.
class Setter {
 public:
  Setter(double size, bool display, Ink ink, const FontMetrics& metrics)
      : base_size_(size), display_(display), ink_(ink), metrics_(metrics) {}

  std::vector<FormulaPiece> pieces(const Formula& formula) {
    std::vector<FormulaPiece> out(1);
    const std::vector<Formula> single{formula};
    const std::vector<Formula>& parts = formula.kind == Kind::row ? formula.parts : single;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      TypesetBox& line = out.back().box;
      const double space = i == 0 ? 0.0 : space_between(parts[i - 1], parts[i], i >= 2 ? &parts[i - 2] : nullptr);
      const TypesetBox part = set(parts[i]);
      const bool after_quad = i > 0 && parts[i - 1].kind == Kind::space && parts[i - 1].width >= 1.0;
      if (after_quad || (i > 0 && parts[i - 1].role == Role::relation)) {
        line.width += space;
        out.push_back({{}, after_quad});
        out.back().box.place(part, {0.0, 0.0});
      } else {
        line.place(part, {line.width + space, 0.0});
      }
    }
    return out;
  }

 private:
  double size() const { return base_size_ * (level_ == 0 ? 1.0 : level_ == 1 ? 0.7 : 0.5) * shrink_; }
  double em() const { return em_of(size()); }
  /// Fraction bars and minus signs lie on it.
  double axis() const { return 0.3135 * em(); }
  double stroke() const { return std::max(1.0, 0.045 * em()); }

  /// A sign without a left side is no binary operation: "-1".
  static bool is_unary(const Formula& sign, const Formula* before) {
    if (sign.role != Role::binary) return false;
    return !before || before->role == Role::relation || before->role == Role::binary || before->role == Role::opening ||
           before->role == Role::punctuation;
  }
  double space_between(const Formula& left, const Formula& right, const Formula* before_left) const {
    if (left.kind == Kind::space || right.kind == Kind::space) return 0.0;
    const bool small = level_ > 0;
    if (left.role == Role::relation || right.role == Role::relation) return (small ? 0.12 : 0.28) * em();
    if (left.role == Role::binary && !is_unary(left, before_left)) return (small ? 0.08 : 0.22) * em();
    if (right.role == Role::binary && !is_unary(right, &left)) return (small ? 0.08 : 0.22) * em();
    if (left.role == Role::punctuation) return 0.2 * em();
    const bool opens = right.role == Role::opening || right.kind == Kind::fenced;
    if (left.role == Role::function && !opens) return 0.17 * em();
    if (right.role == Role::function && left.role == Role::ordinary) return 0.17 * em();
    return 0.0;
  }

  TypesetBox set(const Formula& f) {
    switch (f.kind) {
      case Kind::row:
        return row(f);
      case Kind::symbol:
        return text_box(f.text, {f.bold ? Face::bold : Face::regular, f.italic, size()}, ink_, metrics_);
      case Kind::space: {
        TypesetBox box;
        box.width = f.width * em();
        return box;
      }
      case Kind::fraction:
        return fraction(f);
      case Kind::root:
        return root(set(f.parts[0]));
      case Kind::scripts:
        return scripts(f);
      case Kind::hat:
      case Kind::bar:
        return accent(set(f.parts[0]), f.kind == Kind::hat);
      case Kind::fenced:
        return fenced(f);
    }
    return {};
  }

  TypesetBox row(const Formula& f) {
    TypesetBox line;
    for (std::size_t i = 0; i < f.parts.size(); ++i) {
      const double space = i == 0 ? 0.0 : space_between(f.parts[i - 1], f.parts[i], i >= 2 ? &f.parts[i - 2] : nullptr);
      line.place(set(f.parts[i]), {line.width + space, 0.0});
    }
    return line;
  }

  TypesetBox fraction(const Formula& f) {
    const double outer_shrink = shrink_;
    const bool outer_display = display_;
    if (!display_ && level_ == 0) shrink_ = 0.8;
    display_ = false;
    const TypesetBox over = set(f.parts[0]), under = set(f.parts[1]);
    shrink_ = outer_shrink, display_ = outer_display;
    const double gap = 0.16 * em(), overhang = 0.08 * em(), side = 0.06 * em();
    const double width = std::max(over.width, under.width) + 2 * overhang;
    TypesetBox box;
    box.place(over, {side + 0.5 * (width - over.width), -axis() - gap - over.descent});
    box.place(under, {side + 0.5 * (width - under.width), -axis() + gap + under.ascent});
    box.rules.push_back({{side, -axis() - 0.5 * stroke()}, {side + width, -axis() + 0.5 * stroke()}, ink_});
    box.width = width + 2 * side;
    return box;
  }

  TypesetBox root(const TypesetBox& content) {
    const double gap = 0.14 * em(), hook = 0.55 * em();
    const double top = -std::max(content.ascent, 0.55 * em()) - gap, bottom = content.descent;
    TypesetBox box;
    box.place(content, {hook + 0.06 * em(), 0.0});
    box.width += 0.08 * em();
    const double middle = 0.5 * (top + bottom);
    box.strokes.push_back(
        {{{0.04 * em(), middle + 0.06 * em()}, {0.16 * em(), middle}, {0.32 * em(), bottom}, {hook, top}}, stroke() * 1.2, ink_});
    box.rules.push_back({{hook - 0.5 * stroke(), top - 0.5 * stroke()}, {box.width, top + 0.5 * stroke()}, ink_});
    box.ascent = std::max(box.ascent, -top + stroke());
    return box;
  }

  TypesetBox script(const Formula& f) {
    ++level_;
    TypesetBox box = set(f);
    --level_;
    return box;
  }
  static bool is_prime(const Formula& above) {
    return !above.parts.empty() &&
           std::all_of(above.parts.begin(), above.parts.end(), [](const Formula& p) { return p.text == "′"; });
  }
  TypesetBox scripts(const Formula& f) {
    TypesetBox box = set(f.parts[0]);
    const bool leans = f.parts[0].italic;
    if (is_prime(f.parts[2])) {  // high and small as it is
      box.place(set(f.parts[2]), {box.width, 0.0});
      if (!f.parts[1].parts.empty()) box.place(script(f.parts[1]), {box.width, std::max(0.18 * em(), box.descent - 0.02 * em())});
      return box;
    }
    const double right = box.width + 0.03 * em();
    const TypesetBox below = script(f.parts[1]), above = script(f.parts[2]);
    double raise = std::max(0.38 * em(), box.ascent - 0.32 * em());
    double lower = std::max(0.18 * em(), box.descent - 0.02 * em());
    const bool both = !f.parts[1].parts.empty() && !f.parts[2].parts.empty();
    // A prime's ink is far above its baseline: only what would touch is moved.
    const double overlap = both ? below.ascent - lower - (raise - above.descent) + 0.08 * em() : 0.0;
    if (overlap > 0) raise += 0.5 * overlap, lower += 0.5 * overlap;
    if (!f.parts[1].parts.empty()) box.place(below, {right, lower});
    if (!f.parts[2].parts.empty()) box.place(above, {right + (leans ? 0.08 * em() : 0.0), -raise});
    return box;
  }

  TypesetBox accent(const TypesetBox& content, bool hat) {
    TypesetBox box = content;
    const double y = -content.ascent - 0.1 * em(), middle = 0.5 * content.width + 0.06 * em();
    const double half = hat ? 0.2 * em() : std::max(0.2 * em(), 0.5 * content.width - 0.04 * em());
    if (hat) {
      box.strokes.push_back({{{middle - half, y}, {middle, y - 0.16 * em()}, {middle + half, y}}, stroke(), ink_});
    } else {
      box.rules.push_back({{middle - half, y - stroke()}, {middle + half, y}, ink_});
    }
    box.ascent = content.ascent + 0.3 * em();
    return box;
  }

  TypesetBox fenced(const Formula& f) {
    const TypesetBox content = set(f.parts[0]);
    const double half = std::max(content.ascent - axis(), content.descent + axis());
    TypesetBox box = fence(f.text, half);
    box.place(content, {box.width + 0.04 * em(), 0.0});
    box.place(fence(f.right, half), {box.width + 0.04 * em(), 0.0});
    return box;
  }
  /// As a glyph where one is high enough, else drawn; `half`: its reach above and below the axis.
  TypesetBox fence(const std::string& text, double half) {
    if (text == ".") return {};
    if (half < 0.58 * em()) return text_box(text, {Face::regular, false, size()}, ink_, metrics_);
    half += 0.05 * em();
    const double top = -axis() - half, bottom = -axis() + half;
    const bool left = text == "(" || text == "[";
    const double depth = (text == "|" ? 0.0 : text == "(" || text == ")" ? 0.16 : 0.18) * em() + 0.02 * half;
    const double outer = left ? 0.1 * em() : 0.1 * em() + depth, inner = left ? outer + depth : 0.1 * em();
    TypesetBox box;
    box.width = 0.2 * em() + depth, box.ascent = -top, box.descent = bottom;
    TextStroke line{{}, stroke() * 1.3, ink_};
    if (text == "[" || text == "]") {
      line.points = {{inner, top}, {outer, top}, {outer, bottom}, {inner, bottom}};
    } else {
      for (int i = 0; i <= 12; ++i) {
        const double t = i / 6.0 - 1.0;  // from -1 at the top to 1 at the bottom
        line.points.push_back({outer + (inner - outer) * t * t, -axis() + half * t});
      }
    }
    box.strokes.push_back(std::move(line));
    return box;
  }

  double base_size_, shrink_ = 1.0;
  bool display_;
  Ink ink_;
  const FontMetrics& metrics_;
  int level_ = 0;
};

}  // namespace

std::vector<FormulaPiece> formula_pieces(const Formula& formula, double size, bool display, Ink ink, const FontMetrics& metrics) {
  return Setter(size, display, ink, metrics).pieces(formula);
}

}  // namespace psm
