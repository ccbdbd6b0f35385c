// SPDX-License-Identifier: GPL-3.0-or-later
#include "lesson/typeset.h"

#include <algorithm>

#include "lesson/formula_box.h"

namespace psm {
namespace {

/// What no line break divides, and the blank before it; a line may break there where `breaks`.
struct Piece {
  TypesetBox box;
  double space = 0.0;
  bool breaks = false, breaks_best = false, new_line = false, centred = false;
  std::string link;
};

Type type_of(const Inline& run, const Block& block, double size) {
  Type type{Face::regular, run.emphasis, size};
  if (run.kind == Inline::Kind::code) type.face = Face::mono, type.size = 0.92 * size;
  if (run.strong || block.heading > 0) type.face = Face::bold;
  return type;
}

Ink ink_of(const Inline& run, const Block& block) {
  if (!run.link.empty()) return Ink::link;
  if (run.kind == Inline::Kind::code) return Ink::code;
  if (run.kind == Inline::Kind::live) return Ink::live;
  return block.quote ? Ink::faint : Ink::text;
}

double block_size(const Block& block, double size) {
  constexpr double scale[] = {1.0, 1.5, 1.25, 1.08};
  return scale[block.heading] * size;
}

/// A block's runs as pieces.
class Pieces {
 public:
  Pieces(const Block& block, double size, double width, const FontMetrics& metrics,
         const std::function<std::string(const std::string&)>& live)
      : block_(block), size_(size), width_(width), metrics_(metrics) {
    for (const Inline& run : block.runs) {
      if (run.kind == Inline::Kind::line_break)
        next_.new_line = true;
      else if (run.kind == Inline::Kind::formula || run.kind == Inline::Kind::display_formula)
        add_formula(run);
      else
        add_words(run, run.kind == Inline::Kind::live ? live(run.text) : run.text);
    }
  }
  std::vector<Piece> take() { return std::move(pieces_); }

 private:
  void add(TypesetBox box, const Inline& run) {
    next_.box = std::move(box), next_.link = run.link;
    pieces_.push_back(std::exchange(next_, {}));
  }
  void add_formula(const Inline& run) {
    const bool display = run.kind == Inline::Kind::display_formula;
    const auto formula = parse_formula(run.text);
    if (!formula) return add_words(run, run.text);
    next_.new_line |= display, next_.centred = display;
    for (FormulaPiece& piece : formula_pieces(*formula, size_, display, ink_of(run, block_), metrics_)) {
      next_.breaks_best = display && piece.after_quad;
      add(std::move(piece.box), run);
      next_.breaks = true, next_.centred = display;
    }
    next_ = {};
    next_.new_line = display;
  }
  /// Words break at blanks only: never within "0.5", nor between a word and the formula or point that follows it.
  void add_words(const Inline& run, const std::string& text) {
    const Type type = type_of(run, block_, size_);
    const double blank = metrics_.width(" ", type);
    for (std::size_t at = 0; at < text.size();) {
      if (text[at] == ' ' || text[at] == '\n') {
        next_.space = blank, next_.breaks = true, ++at;
        continue;
      }
      const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
      add_word(run, type, text.substr(at, end - at));
      at = end;
    }
  }
  /// A word that no line could hold is divided between characters.
  void add_word(const Inline& run, const Type& type, const std::string& word) {
    TypesetBox box = text_box(word, type, ink_of(run, block_), metrics_);
    box.ascent = std::max(box.ascent, 0.55 * type.size);
    std::size_t half = word.size() / 2;
    while (half > 0 && (word[half] & 0xC0) == 0x80) --half;
    if (box.width <= width_ || half == 0) return add(std::move(box), run);
    add_word(run, type, word.substr(0, half));
    next_.breaks = true;
    add_word(run, type, word.substr(half));
  }

  const Block& block_;
  double size_, width_;
  const FontMetrics& metrics_;
  std::vector<Piece> pieces_;
  Piece next_;
};

/// Puts lines below each other.
class Setter {
 public:
  Setter(const PageStyle& style, const FontMetrics& metrics) : style_(style), metrics_(metrics) {}

  void add(const Block& block, bool first, const std::function<std::string(const std::string&)>& live) {
    const double size = block_size(block, style_.size), indent = indent_of(block);
    if (!first) y_ += space_before(block);
    const double top = y_, width = std::max(style_.width - indent, 2.0 * style_.size);
    const std::vector<Piece> pieces = Pieces(block, size, width, metrics_, live).take();
    for (std::size_t begin = 0; begin < pieces.size();) {
      const std::size_t end = line_end(pieces, begin, width);
      const double baseline = set_line(pieces, begin, end, size, indent, width);
      if (begin == 0 && !block.marker.empty()) set_marker(block, size, indent, baseline);
      begin = end;
    }
    if (block.quote) page_.ink.rules.push_back({{0.0, top}, {std::max(2.0, 0.12 * style_.size), y_}, Ink::faint});
    last_was_item_ = block.indent > 0;
  }
  TextPage take() {
    page_.height = y_;
    page_.ink.width = style_.width;
    return std::move(page_);
  }

 private:
  double indent_of(const Block& block) const { return (1.3 * block.indent + (block.quote ? 0.8 : 0.0)) * style_.size; }
  double space_before(const Block& block) const {
    if (block.heading > 0) return 1.0 * style_.size;
    return (block.indent > 0 && last_was_item_ ? 0.25 : 0.6) * style_.size;
  }

  /// One past the last piece of the line that begins here. Breaks where the text allows it, last before the width is full.
  static std::size_t line_end(const std::vector<Piece>& pieces, std::size_t begin, double width) {
    double x = pieces[begin].box.width;
    std::size_t last_break = begin, best_break = begin;
    for (std::size_t i = begin + 1; i < pieces.size(); ++i) {
      if (pieces[i].new_line) return i;
      if (pieces[i].breaks) last_break = i;
      if (pieces[i].breaks_best) best_break = i;
      x += pieces[i].space + pieces[i].box.width;
      if (x > width && last_break > begin) return best_break > begin ? best_break : last_break;
    }
    return pieces.size();
  }

  /// Returns the baseline.
  double set_line(const std::vector<Piece>& pieces, std::size_t begin, std::size_t end, double size, double indent,
                  double width) {
    double used = 0.0, ascent = 0.62 * size, descent = 0.2 * size;
    for (std::size_t i = begin; i < end; ++i) {
      used += (i > begin ? pieces[i].space : 0.0) + pieces[i].box.width;
      ascent = std::max(ascent, pieces[i].box.ascent), descent = std::max(descent, pieces[i].box.descent);
    }
    // What is higher than a line of text moves its neighbours apart, and no more than it must.
    const double gap = 0.08 * size, usual = style_.leading * em_of(size);
    const double height = std::max(usual, ascent + descent + gap);
    const double extra = std::max(0.0, usual - 0.82 * size);
    const double baseline = y_ + std::max(ascent + gap * 0.5, 0.62 * size + 0.5 * extra);
    double x = indent + (pieces[begin].centred ? std::max(0.0, 0.5 * (width - used)) : 0.0);
    for (std::size_t i = begin; i < end; ++i) {
      if (i > begin) x += pieces[i].space;
      page_.ink.place(pieces[i].box, {x, baseline});
      add_link(pieces[i], i > begin ? pieces[i].space : 0.0, x, baseline, size);
      x += pieces[i].box.width;
    }
    y_ = std::max(y_ + height, baseline + descent + gap * 0.5);
    return baseline;
  }

  /// Neighbours on a line that lead to the same place are one area.
  void add_link(const Piece& piece, double space, double x, double baseline, double size) {
    if (piece.link.empty()) return;
    const LinkArea area{{x, baseline - 0.8 * size}, {x + piece.box.width, baseline + 0.25 * size}, piece.link};
    if (!page_.links.empty()) {
      LinkArea& last = page_.links.back();
      if (last.target == area.target && last.max.y == area.max.y && last.max.x + space >= area.min.x - 1e-6) {
        last.max.x = area.max.x;
        return;
      }
    }
    page_.links.push_back(area);
  }

  void set_marker(const Block& block, double size, double indent, double baseline) {
    const TypesetBox marker = text_box(block.marker, {Face::regular, false, size}, Ink::faint, metrics_);
    page_.ink.place(marker, {indent - marker.width - 0.35 * size, baseline});
  }

  PageStyle style_;
  const FontMetrics& metrics_;
  TextPage page_;
  double y_ = 0.0;
  bool last_was_item_ = false;
};

}  // namespace

TextPage typeset(const std::vector<Block>& blocks, const PageStyle& style, const FontMetrics& metrics,
                 const std::function<std::string(const std::string& path)>& live) {
  Setter setter(style, metrics);
  for (std::size_t i = 0; i < blocks.size(); ++i) setter.add(blocks[i], i == 0, live);
  return setter.take();
}

}  // namespace psm
