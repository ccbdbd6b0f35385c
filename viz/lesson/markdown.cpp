// SPDX-License-Identifier: GPL-3.0-or-later
#include "lesson/markdown.h"

#include <md4c.h>

#include <algorithm>

#include "lesson/formula.h"

namespace psm {
namespace {

constexpr const char* kAllowed =
    "; allowed: headings, paragraphs, bullet and numbered lists, quotes, emphasis, links, inline code, $formulas$";

/// Gathers blocks from the parser's events. Its texts are pieces of the source, so that a pointer tells the line.
class Gatherer {
 public:
  explicit Gatherer(const std::string& source) : source_(source) {}

  std::vector<Block> blocks;
  std::string error;

  bool enter_block(MD_BLOCKTYPE type, void* detail) {
    if (type == MD_BLOCK_UL || type == MD_BLOCK_OL) return enter_list(type, detail);
    if (type == MD_BLOCK_LI) return marker_pending_ = true, begin_block();
    if (type == MD_BLOCK_QUOTE) return ++quotes_, true;
    if (type == MD_BLOCK_P || type == MD_BLOCK_H) return enter_text(type, detail);
    if (type == MD_BLOCK_DOC) return true;
    if (type == MD_BLOCK_HR) return refuse("a line across the page, below this line");
    return refuse_next_text(type == MD_BLOCK_HTML ? "HTML" : type == MD_BLOCK_TABLE ? "a table" : "a block of code");
  }

  bool leave_block(MD_BLOCKTYPE type) {
    if (!refused_.empty()) return refuse(refused_);
    if (type == MD_BLOCK_UL || type == MD_BLOCK_OL) lists_.pop_back();
    if (type == MD_BLOCK_QUOTE) --quotes_;
    // What follows a nested list in the same item is a block of its own.
    if (type != MD_BLOCK_DOC) open_ = false;
    return true;
  }

  bool enter_span(MD_SPANTYPE type, void* detail) {
    if (type == MD_SPAN_IMG) return refuse_next_text("an image");
    if (type == MD_SPAN_EM) ++emphasis_;
    if (type == MD_SPAN_STRONG) ++strong_;
    if (type == MD_SPAN_A) {
      const MD_ATTRIBUTE& href = static_cast<MD_SPAN_A_DETAIL*>(detail)->href;
      link_.assign(href.text ? href.text : "", href.size);
      if (link_.empty()) return refuse_next_text("a link that leads nowhere");
    }
    begin_run_ = true;
    display_ = type == MD_SPAN_LATEXMATH_DISPLAY;
    return true;
  }

  bool leave_span(MD_SPANTYPE type) {
    if (type == MD_SPAN_EM) --emphasis_;
    if (type == MD_SPAN_STRONG) --strong_;
    if (type == MD_SPAN_A) link_.clear();
    if (type == MD_SPAN_CODE) close_code();
    if (type == MD_SPAN_LATEXMATH || type == MD_SPAN_LATEXMATH_DISPLAY) return check_formula();
    begin_run_ = true;
    return true;
  }

  bool text(MD_TEXTTYPE type, const char* text, MD_SIZE size) {
    move_to(text);
    if (!refused_.empty()) return refuse(refused_);
    if (type == MD_TEXT_HTML) return refuse("HTML");
    if (type == MD_TEXT_NULLCHAR) return refuse("a zero byte");
    if (type == MD_TEXT_ENTITY) return refuse("an entity such as &amp;");
    if (type == MD_TEXT_BR) return add(Inline::Kind::line_break, "");
    if (type == MD_TEXT_SOFTBR) return add(Inline::Kind::words, " ");
    const std::string piece(text, size);
    if (type == MD_TEXT_CODE) return add(Inline::Kind::code, piece);
    if (type == MD_TEXT_LATEXMATH) return add(display_ ? Inline::Kind::display_formula : Inline::Kind::formula, piece);
    if (piece.find('$') != std::string::npos && !follows_backslash(text)) return refuse("a $ without its partner");
    return add(Inline::Kind::words, piece);
  }

 private:
  struct List {
    bool numbered = false;
    unsigned next = 1;
  };

  bool refuse(const std::string& what) {
    if (error.empty()) error = std::to_string(line_) + ": " + what + kAllowed;
    return false;
  }
  /// What has no place of its own is refused where its first text stands.
  bool refuse_next_text(const std::string& what) {
    if (refused_.empty()) refused_ = what;
    return true;
  }
  bool enter_list(MD_BLOCKTYPE type, void* detail) {
    if (lists_.size() == 2) return refuse_next_text("a list three levels deep");
    List list;
    list.numbered = type == MD_BLOCK_OL;
    if (list.numbered) list.next = static_cast<MD_BLOCK_OL_DETAIL*>(detail)->start;
    lists_.push_back(list);
    open_ = false;
    return true;
  }
  bool enter_text(MD_BLOCKTYPE type, void* detail) {
    begin_block();
    const unsigned level = type == MD_BLOCK_H ? static_cast<MD_BLOCK_H_DETAIL*>(detail)->level : 0;
    if (level > 3) return refuse("a heading of level " + std::to_string(level));
    if (level > 0 && (!lists_.empty() || quotes_ > 0)) return refuse("a heading inside a list or a quote");
    if (level > 0) blocks.emplace_back(), blocks.back().heading = int(level), open_ = true;
    return true;
  }
  bool begin_block() {
    open_ = false;
    begin_run_ = true;
    return true;
  }
  /// The block comes into being with its first text, whose line is then known.
  void open_block() {
    if (!open_) {
      blocks.emplace_back();
      Block& block = blocks.back();
      block.indent = int(lists_.size());
      block.quote = quotes_ > 0;
      if (marker_pending_ && !lists_.empty()) {
        List& list = lists_.back();
        block.marker = list.numbered ? std::to_string(list.next++) + "." : "\u2022";
      }
      marker_pending_ = false;
      open_ = true;
    }
    if (blocks.back().runs.empty()) blocks.back().line = line_;
  }
  bool add(Inline::Kind kind, const std::string& piece) {
    open_block();
    std::vector<Inline>& runs = blocks.back().runs;
    if (!begin_run_ && !runs.empty() && runs.back().kind == kind) {
      runs.back().text += piece;
      return true;
    }
    begin_run_ = false;
    runs.push_back({kind, piece, emphasis_ > 0, strong_ > 0, link_, line_});
    return true;
  }
  /// Code that begins with = is a live value.
  void close_code() {
    if (blocks.empty() || blocks.back().runs.empty()) return;
    Inline& run = blocks.back().runs.back();
    if (run.kind != Inline::Kind::code || run.text.size() < 2 || run.text[0] != '=') return;
    run.kind = Inline::Kind::live;
    run.text.erase(0, 1);
  }
  bool check_formula() {
    begin_run_ = true;
    if (blocks.empty() || blocks.back().runs.empty()) return refuse("an empty formula");
    const Inline& run = blocks.back().runs.back();
    const auto formula = parse_formula(run.text);
    if (!formula && error.empty()) error = std::to_string(run.line) + ": " + formula.error().text;
    return bool(formula);
  }
  bool in_source(const char* text) const { return text >= source_.data() && text < source_.data() + source_.size(); }
  bool follows_backslash(const char* text) const { return in_source(text) && text > source_.data() && text[-1] == '\\'; }
  void move_to(const char* text) {
    if (!in_source(text)) return;  // a constant of the parser, such as the blank at a line's end
    if (text < counted_to_) counted_to_ = source_.data(), line_ = 1;  // pieces come almost in order
    line_ += int(std::count(counted_to_, text, '\n'));
    counted_to_ = text;
  }

  const std::string& source_;
  const char* counted_to_ = source_.data();  // the line of which is line_
  int line_ = 1, quotes_ = 0, emphasis_ = 0, strong_ = 0;
  bool open_ = false, begin_run_ = true, marker_pending_ = false, display_ = false;
  std::string link_, refused_;
  std::vector<List> lists_;
};

Gatherer& gatherer(void* user) { return *static_cast<Gatherer*>(user); }
int stop_unless(bool fine) { return fine ? 0 : 1; }

}  // namespace

Result<std::vector<Block>> parse_markdown(const std::string& text) {
  Gatherer gathered(text);
  MD_PARSER parser{};
  parser.flags = MD_FLAG_LATEXMATHSPANS | MD_FLAG_TABLES;
  parser.enter_block = [](MD_BLOCKTYPE type, void* detail, void* user) {
    return stop_unless(gatherer(user).enter_block(type, detail));
  };
  parser.leave_block = [](MD_BLOCKTYPE type, void*, void* user) { return stop_unless(gatherer(user).leave_block(type)); };
  parser.enter_span = [](MD_SPANTYPE type, void* detail, void* user) {
    return stop_unless(gatherer(user).enter_span(type, detail));
  };
  parser.leave_span = [](MD_SPANTYPE type, void*, void* user) { return stop_unless(gatherer(user).leave_span(type)); };
  parser.text = [](MD_TEXTTYPE type, const MD_CHAR* piece, MD_SIZE size, void* user) {
    return stop_unless(gatherer(user).text(type, piece, size));
  };
  const int failed = md_parse(text.data(), MD_SIZE(text.size()), &parser, &gathered);
  if (!gathered.error.empty()) return InputError{gathered.error};
  if (failed) return InputError{"1: cannot be parsed as Markdown"};
  return std::move(gathered.blocks);
}

std::string plain_text(const Block& block) {
  std::string text;
  for (const Inline& run : block.runs) {
    const bool formula = run.kind == Inline::Kind::formula || run.kind == Inline::Kind::display_formula;
    text += formula ? "$" + run.text + "$" : run.kind == Inline::Kind::line_break ? " " : run.text;
  }
  return text;
}

}  // namespace psm
