// SPDX-License-Identifier: GPL-3.0-or-later
#include "lesson/formula.h"

#include <cctype>

#include "lesson/formula_symbols.h"
#include "scene/experiment_members.h"

namespace psm {
namespace {

using Kind = Formula::Kind;
using Role = Formula::Role;

Formula make(Kind kind, std::vector<Formula> parts = {}) {
  Formula formula;
  formula.kind = kind;
  formula.parts = std::move(parts);
  return formula;
}

Formula symbol(const FormulaSymbol& s) {
  Formula formula = make(Kind::symbol);
  formula.text = s.text, formula.role = s.role, formula.italic = s.italic;
  return formula;
}

Formula space(double em) {
  Formula formula = make(Kind::space);
  formula.width = em;
  return formula;
}

/// Recursive descent. After the first error everything returns at once.
class Parser {
 public:
  explicit Parser(const std::string& tex) : tex_(tex) {}

  std::string error;

  Formula whole() {
    Formula row = parse_row("");
    if (error.empty() && at_ < tex_.size()) refuse("'" + quotable(tex_.substr(at_, 1)) + "' without its partner");
    if (error.empty() && row.parts.empty()) refuse("an empty formula");
    return row;
  }

 private:
  static constexpr int kDeepest = 12;

  void refuse(const std::string& what) {
    if (error.empty()) error = what;
    at_ = tex_.size();
  }
  void skip_blanks() {
    while (at_ < tex_.size() && (tex_[at_] == ' ' || tex_[at_] == '\n' || tex_[at_] == '\t' || tex_[at_] == '\r')) ++at_;
  }
  bool next_is(char c) {
    skip_blanks();
    return at_ < tex_.size() && tex_[at_] == c;
  }
  /// The name after a backslash, or the one character that is no letter.
  std::string command_name() {
    std::size_t end = at_ + 1;
    while (end < tex_.size() && std::isalpha(static_cast<unsigned char>(tex_[end]))) ++end;
    if (end == at_ + 1) ++end;
    return tex_.substr(at_ + 1, end - at_ - 1);
  }
  void expect(char c, const char* where) {
    if (!next_is(c)) return refuse(std::string("'") + c + "' is missing " + where);
    ++at_;
  }

  /// Up to '}', the end, or \right (left where it is).
  Formula parse_row(const std::string& ending) {
    Formula row = make(Kind::row);
    if (++depth_ > kDeepest) refuse("nested too deeply; allowed: 12 levels");
    while (error.empty()) {
      skip_blanks();
      if (at_ >= tex_.size() || tex_[at_] == '}') break;
      if (tex_[at_] == '\\' && command_name() == "right") {
        if (ending != "right") refuse("\\right without \\left");
        break;
      }
      row.parts.push_back(parse_with_scripts());
    }
    --depth_;
    return row;
  }
  Formula parse_group(const char* what) {
    expect('{', what);
    Formula row = parse_row("}");
    expect('}', "at the end of a group");
    if (error.empty() && row.parts.empty()) refuse(std::string("nothing between the braces ") + what);
    return row;
  }
  Formula parse_with_scripts() {
    if (tex_[at_] == '_' || tex_[at_] == '^') return refuse("a script that stands on nothing"), Formula{};
    Formula base = parse_atom(), below, above;
    bool has_below = false, has_above = false;
    for (skip_blanks(); at_ < tex_.size(); skip_blanks()) {
      const char c = tex_[at_];
      if (c == '\'') {
        // A prime before ^ joins it.
        ++at_, has_above = true;
        above.parts.push_back(symbol(*symbol_of_character(c)));
      } else if (c == '_' || c == '^') {
        ++at_;
        bool& has = c == '_' ? has_below : has_above;
        Formula& script = c == '_' ? below : above;
        if (has && (c == '_' || script.parts.empty() || script.parts.back().text != "′")) {
          refuse(std::string("two scripts '") + c + "' on the same base");
          break;
        }
        has = true;
        script.parts.push_back(parse_script());
      } else {
        break;
      }
      if (!error.empty()) break;
    }
    if (!has_below && !has_above) return base;
    const Role role = base.role;
    Formula scripts = make(Kind::scripts, {std::move(base), std::move(below), std::move(above)});
    scripts.role = role;
    return scripts;
  }
  Formula parse_script() {
    skip_blanks();
    if (at_ >= tex_.size()) return refuse("a script without content"), Formula{};
    return tex_[at_] == '{' ? parse_group("of a script") : parse_atom();
  }
  Formula parse_atom() {
    const char c = tex_[at_];
    if (c == '{') return parse_group("of a group");
    if (c == '\\') return parse_command();
    if (std::isdigit(static_cast<unsigned char>(c))) return parse_number();
    ++at_;
    if (std::isalpha(static_cast<unsigned char>(c))) {
      Formula letter = make(Kind::symbol);
      letter.text = c, letter.italic = true;
      return letter;
    }
    if (const FormulaSymbol* known = symbol_of_character(c)) return symbol(*known);
    --at_;
    refuse("'" + shown_character() +
           "' is not allowed in a formula; allowed: letters, digits, + - = < > ( ) [ ] | , . / ' ; : and commands");
    return {};
  }
  std::string shown_character() const {
    std::size_t end = at_ + 1;
    while (end < tex_.size() && (tex_[end] & 0xC0) == 0x80) ++end;
    return quotable(tex_.substr(at_, end - at_));
  }
  /// Digits with a point among them: one symbol, which no line break divides.
  Formula parse_number() {
    const auto digit = [&](std::size_t i) { return i < tex_.size() && std::isdigit(static_cast<unsigned char>(tex_[i])); };
    std::size_t end = at_;
    while (digit(end) || (end < tex_.size() && tex_[end] == '.' && digit(end + 1))) ++end;
    Formula number = make(Kind::symbol);
    number.text = tex_.substr(at_, end - at_);
    at_ = end;
    return number;
  }
  Formula parse_command() {
    const std::string name = command_name();
    at_ += 1 + name.size();
    if (name == "frac") {
      Formula over = parse_group("after \\frac"), under = parse_group("after \\frac{}");
      return make(Kind::fraction, {std::move(over), std::move(under)});
    }
    if (name == "sqrt") return make(Kind::root, {parse_group("after \\sqrt")});
    if (name == "hat") return make(Kind::hat, {parse_group("after \\hat")});
    if (name == "bar") return make(Kind::bar, {parse_group("after \\bar")});
    if (name == "text") return parse_words(false);
    if (name == "mathbf") return parse_words(true);
    if (name == "left") return parse_fenced();
    if (name == "quad") return space(1.0);
    if (name == ",") return space(0.17);
    if (name == ";") return space(0.28);
    if (const FormulaSymbol* known = symbol_of_command(name)) return symbol(*known);
    refuse(
        "\\" + quotable(name) +
        ": no such command; allowed: \\frac \\sqrt \\text \\mathbf \\hat \\bar \\left \\right \\quad \\, \\; Greek letters, and "
        "the signs "
        "and functions that lessons/README.md lists");
    return {};
  }
  Formula parse_words(bool bold) {
    expect('{', bold ? "after \\mathbf" : "after \\text");
    const std::size_t end = tex_.find_first_of("{}", at_);
    if (!error.empty() || end == std::string::npos || tex_[end] != '}')
      return refuse("'}' is missing at the end of a text"), Formula{};
    Formula words = make(Kind::symbol);
    words.text = tex_.substr(at_, end - at_), words.bold = bold;
    at_ = end + 1;
    return words;
  }
  std::string parse_fence(const char* after) {
    skip_blanks();
    const char c = at_ < tex_.size() ? tex_[at_] : '\0';
    if (c == '\0' || std::string("()[]|.").find(c) == std::string::npos)
      return refuse(std::string("no fence after ") + after + "; allowed: ( ) [ ] | ."), "";
    ++at_;
    return std::string(1, c);
  }
  Formula parse_fenced() {
    Formula fenced = make(Kind::fenced);
    fenced.text = parse_fence("\\left");
    fenced.parts.push_back(parse_row("right"));
    if (error.empty() && !(at_ < tex_.size() && tex_[at_] == '\\')) return refuse("\\left without \\right"), Formula{};
    if (!error.empty()) return {};
    at_ += std::string("\\right").size();
    fenced.right = parse_fence("\\right");
    return fenced;
  }

  const std::string& tex_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

Result<Formula> parse_formula(const std::string& tex) {
  Parser parser(tex);
  Formula formula = parser.whole();
  if (!parser.error.empty()) return InputError{"formula \"" + quotable(tex) + "\": " + parser.error};
  return formula;
}

}  // namespace psm
