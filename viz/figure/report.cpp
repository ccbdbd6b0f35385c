// SPDX-License-Identifier: GPL-3.0-or-later
#include "figure/report.h"

#include <cmath>
#include <locale>
#include <map>
#include <sstream>

#include "figure/report_parts.h"
#include "measure/study.h"

namespace psm {
namespace {

/// The page, and each plot once more as a file of its own.
struct Writer {
  HtmlPage page{"Shadow maps: speed against error"};
  std::vector<ReportFile> files;

  void plot(const std::string& name, const Plot& plot, const std::string& caption) {
    files.push_back({name + ".svg", plot_svg(plot, true)});
    page.figure(plot_svg(plot, false), caption);
  }
};

void write_introduction(Writer& w, const ReportInput& in) {
  w.page.paragraph(
      "Each row is one shadow map: its error against ray-traced hard shadows of the same triangles, pixel by pixel, and the time "
      "of "
      "its stages. A pixel is wrong where the map says lit and the truth dark, or the reverse; m is the largest extent of a "
      "shadow-map texel in pixels of the image.");
  w.page.paragraph(std::to_string(in.rows.size()) + " of " + std::to_string(in.planned) +
                   " runs are measured. Every row, with all columns, stands in rows.csv beside this page. Errors are the same "
                   "whenever the same program measures them; times are medians and depend on the machine.");
  w.page.table(machine_table(in.rows));
}

void write_scene(Writer& w, const std::string& scene, const std::vector<StudyRow>& rows) {
  w.page.heading("Scene " + scene + ": what an error costs");
  w.plot(
      scene + "_time", error_plot(rows, true),
      "Grey steps: the Pareto front over all techniques, those that are not drawn included: nothing below and to the left of it "
      "was measured. Both axes are logarithmic.");
  w.plot(scene + "_texels", error_plot(rows, false),
         "The same errors against the memory that the maps take: texels along the side of a square.");
  w.page.table(error_table(rows));
  w.page.table(cause_table(rows));
  w.page.table(time_table(rows));
  w.plot(
      scene + "_equal", equal_error_plot(rows),
      "Figure 1 of the 2002 paper as a number. A gap: no uniform map that was tried is as good, or the technique was replaced.");
  w.page.table(equal_error_table(rows));
  w.page.table(best_plane_table(rows));
}

bool is_slab(const std::string& scene) { return scene == kSlab || scene == kSlabVisible || scene == kSlabFar; }

void write_slab(Writer& w, const std::vector<StudyRow>& rows, const CitedTable& cited) {
  const auto of = [&](const char* scene) { return rows_where(rows, [&](const StudyRow& r) { return r.scene == scene; }); };
  const std::vector<StudyRow> slab = of(kSlab), visible = of(kSlabVisible), far = of(kSlabFar);
  w.page.heading("One scene, all angles: what users could pick instead");
  w.plot("one_scene", texel_size_plot(slab),
         "The eye 1.7 above a slab of 200 x 10 x 200 with its top at y = 0, 60 degrees high, n = 1, f = 100. The limit is "
         "the image's width over the map's: with rows of the map along the horizon no single map of this size goes below it. "
         "Gaps: the technique was replaced there.");
  w.page.table(cited_table(cited));
  for (const bool behind : {false, true}) {
    w.page.table(slab_table(slab, "window around the receivers' body (focus: bounds)", behind));
    w.page.table(slab_table(visible, "window around what is visible (focus: visible)", behind));
  }
  w.page.table(far_table(far));
}

void write_closed_forms(Writer& w, const ReportInput& in) {
  w.page.heading("Closed forms and the lower bound");
  w.plot(
      "closed_forms", closed_form_plot(in.closed_forms, in.closed_form_setting),
      "GMNPR 2007's two-dimensional model against the maps that the analysis makes in three dimensions, where the receivers fill "
      "the frustum. The line of psm, which has no closed form there, joins its dots.");
  w.page.table(closed_form_table(in.closed_forms, in.closed_form_setting));
}

void write_hard_cases(Writer& w, const ReportInput& in) {
  w.page.heading("Float, double, exact");
  std::map<std::string, int> verdicts;
  for (const MeasuredCase& c : in.hard_cases) ++verdicts[name_of(c.verdict)];
  std::string text;
  for (const auto& [verdict, count] : verdicts) text += (text.empty() ? "" : ", ") + verdict + ": " + std::to_string(count);
  w.page.paragraph(text + ". Measured on " + in.machine.cpu + ", " + in.machine.compiler + ".");
  w.page.table(hard_case_table(in.hard_cases));
}

std::string rows_csv(const std::vector<StudyRow>& rows) {
  std::string csv = csv_header();
  for (const StudyRow& row : rows) csv += csv_line(row);
  return csv;
}

/// Parts of a line; quotes hold commas together.
std::vector<std::string> parts_of(const std::string& line) {
  std::vector<std::string> parts(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

double number_of(const std::string& text) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double value = kNone;
  return stream >> value ? value : kNone;
}

}  // namespace

Result<CitedTable> read_cited_table(const std::string& csv, const std::string& name) {
  CitedTable table;
  std::istringstream lines(csv);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.rfind("# ", 0) == 0) {
      table.source += (table.source.empty() ? "" : " ") + line.substr(2);
      continue;
    }
    const std::vector<std::string> parts = parts_of(line);
    std::vector<double> numbers;
    for (std::size_t i = 2; i < parts.size(); ++i) numbers.push_back(number_of(parts[i]));
    if (table.theta_deg.empty())
      table.theta_deg = numbers;
    else
      table.rows.push_back({parts[0], parts.size() > 1 ? number_of(parts[1]) : kNone, numbers});
    if (numbers.empty() || numbers.size() != table.theta_deg.size())
      return InputError{name + ": line " + std::to_string(number) + ": " + std::to_string(numbers.size()) +
                        " numbers; allowed: as many as the first line has angles"};
  }
  return table;
}

std::vector<ReportFile> make_report(const ReportInput& input) {
  Writer w;
  write_introduction(w, input);
  for (const std::string& scene : names_in(input.rows, &StudyRow::scene))
    if (!is_slab(scene)) write_scene(w, scene, rows_where(input.rows, [&](const StudyRow& r) { return r.scene == scene; }));
  write_slab(w, rows_where(input.rows, [](const StudyRow& r) { return is_slab(r.scene); }), input.cited);
  write_closed_forms(w, input);
  write_hard_cases(w, input);
  w.files.push_back({"rows.csv", rows_csv(input.rows)});
  w.files.push_back({"index.html", w.page.text()});
  return std::move(w.files);
}

}  // namespace psm
