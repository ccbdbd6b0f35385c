// SPDX-License-Identifier: GPL-3.0-or-later
// One self-contained page: headings, paragraphs, tables and pictures, one after another.
#pragma once

#include <string>
#include <vector>

namespace psm {

struct HtmlTable {
  std::string caption;  // what is in it, under which conditions
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;  // as long as the head; the first column names the row
};

/// All texts are plain: it is the page that makes HTML of them. But `figure` takes an <svg> element.
class HtmlPage {
 public:
  explicit HtmlPage(std::string title) : title_(std::move(title)) {}
  void heading(const std::string& text);
  void paragraph(const std::string& text);
  void table(const HtmlTable& table);
  void figure(const std::string& svg, const std::string& caption);
  std::string text() const;

 private:
  std::string title_, body_;
};

}  // namespace psm
