// SPDX-License-Identifier: GPL-3.0-or-later
#include "figure/html.h"

#include <algorithm>

#include "figure/plot.h"

namespace psm {
namespace {

// Large enough to be read from the back of a room; a table or a figure is not torn apart on paper.
constexpr const char* kStyle = R"(
body { font: 20px/1.45 "DejaVu Sans", Verdana, Arial, sans-serif; color: #222; background: #fff; max-width: 1160px;
  margin: 2em auto; padding: 0 1em; }
h1 { font-size: 1.9em; line-height: 1.2; }
h2 { font-size: 1.4em; margin-top: 2.2em; border-bottom: 3px solid #0072B2; }
figure { margin: 1.5em 0; break-inside: avoid; }
figure svg { width: 100%; height: auto; display: block; }
figcaption { font-size: 0.9em; color: #444; padding: 0.4em 0; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: 0.85em; margin: 0.3em 0; }
th, td { padding: 0.25em 0.6em; border-bottom: 1px solid #ccc; text-align: right; white-space: nowrap; }
th:first-child, td:first-child { text-align: left; white-space: normal; }
.small { font-size: 0.7em; }
.small th, .small td { padding: 0.25em 0.4em; white-space: normal; }
.small td:first-child { min-width: 14em; }
thead th { border-bottom: 2px solid #222; vertical-align: bottom; }
tbody tr:nth-child(even) { background: #f4f6f8; }
@media print { body { font-size: 11pt; max-width: none; margin: 0; } h2 { break-after: avoid; } tr { break-inside: avoid; }
  .wide { overflow: visible; } table { font-size: 8pt; } .small { font-size: 6.5pt; }
  th, td { padding: 0.2em 0.4em; } }
)";

constexpr std::size_t kWidest = 105;  // characters that the page has room for, beside a first column that breaks its lines

/// In characters, two between columns.
std::size_t width_of(const HtmlTable& table) {
  std::size_t width = 0;
  for (std::size_t column = 1; column < table.head.size(); ++column) {
    std::size_t longest = table.head[column].size();
    for (const auto& row : table.rows) longest = std::max(longest, row[column].size());
    width += longest + 2;
  }
  return width;
}

std::string row_html(const std::vector<std::string>& cells, const char* tag, const char* scope) {
  std::string html = "<tr>";
  for (const std::string& cell : cells) html += std::string("<") + tag + scope + ">" + xml_text(cell) + "</" + tag + ">";
  return html + "</tr>\n";
}

}  // namespace

void HtmlPage::heading(const std::string& text) { body_ += "<h2>" + xml_text(text) + "</h2>\n"; }
void HtmlPage::paragraph(const std::string& text) { body_ += "<p>" + xml_text(text) + "</p>\n"; }

void HtmlPage::table(const HtmlTable& table) {
  body_ += "<figure>\n<figcaption>" + xml_text(table.caption) + "</figcaption>\n<div class=\"wide\"><table" +
           (width_of(table) > kWidest ? " class=\"small\"" : "") + ">\n<thead>\n";
  body_ += row_html(table.head, "th", " scope=\"col\"") + "</thead>\n<tbody>\n";
  for (const auto& row : table.rows) body_ += row_html(row, "td", "");
  body_ += "</tbody>\n</table></div>\n</figure>\n";
}

void HtmlPage::figure(const std::string& svg, const std::string& caption) {
  body_ += "<figure>\n" + svg + "<figcaption>" + xml_text(caption) + "</figcaption>\n</figure>\n";
}

std::string HtmlPage::text() const {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>" +
         xml_text(title_) + "</title>\n<style>" + kStyle + "</style>\n</head>\n<body>\n<h1>" + xml_text(title_) + "</h1>\n" +
         body_ + "</body>\n</html>\n";
}

}  // namespace psm
