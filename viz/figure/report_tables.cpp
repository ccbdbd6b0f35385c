// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "figure/report_parts.h"
#include "measure/repeats.h"

namespace psm {
namespace {

constexpr const char* kStar = " A star: the technique was replaced there by another one, which rows.csv names.";

std::string texels(double resolution) { return shown(resolution, 5); }

/// A head of angles after the name of the first column.
std::vector<std::string> angle_head(const std::string& first, const std::vector<double>& angles) {
  std::vector<std::string> head{first};
  for (const double theta : angles) head.push_back(angle(theta));
  return head;
}

/// One line a technique, one column an angle, at one resolution.
template <class Cell>
void fill_over_angles(HtmlTable& table, const std::vector<StudyRow>& rows, double resolution, const std::vector<double>& angles,
                      Cell cell) {
  for (const std::string& technique : names_in(rows, &StudyRow::technique)) {
    std::vector<std::string> line{technique};
    for (const double theta : angles) line.push_back(cell(find_row(rows, technique, resolution, theta)));
    table.rows.push_back(std::move(line));
  }
}

std::string share(const StudyRow& row, double pixels) { return percent(row.compared > 0 ? pixels / row.compared : kNone); }

std::string equal_error_text(const StudyRow* row) {
  if (!row || std::isnan(row->equal_error_resolution)) return "\u2013";
  if (std::isinf(row->equal_error_resolution)) return "none";
  const double ratio = row->equal_error_resolution / row->resolution;
  return texels(row->equal_error_resolution) + " (" + shown(ratio, 3) + "\u00d7)" + (as_asked(*row) ? "" : "*");
}

/// So that a long name has where to break.
std::string with_blanks(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::string answer(const CaseAnswer& a) {
  if (!a.named.empty()) return with_blanks(a.named);
  return std::isnan(double(a.value)) ? "not a number" : shown(double(a.value), 9);
}

}  // namespace

HtmlTable error_table(const std::vector<StudyRow>& rows) {
  const double theta = reference_theta(rows);
  HtmlTable table;
  table.caption = "Wrong pixels in percent of those that ray-traced hard shadows call dark or lit; light at " + angle(theta) +
                  "; columns: texels along a side of the map; " + conditions(rows) + "." + kStar;
  table.head = {"technique"};
  const std::vector<double> resolutions = values_in(rows, &StudyRow::resolution);
  for (const double resolution : resolutions) table.head.push_back(texels(resolution));
  for (const std::string& technique : names_in(rows, &StudyRow::technique)) {
    std::vector<std::string> line{technique};
    for (const double resolution : resolutions) {
      const StudyRow* row = find_row(rows, technique, resolution, theta);
      line.push_back(row && row->compared > 0 ? percent(row->error_fraction) + (as_asked(*row) ? "" : "*") : "\u2013");
    }
    table.rows.push_back(std::move(line));
  }
  return table;
}

namespace {

/// One line a technique at the angle and the resolution that stand for all.
template <class Cells>
HtmlTable reference_table(const std::vector<StudyRow>& rows, const std::string& what, const std::vector<std::string>& head,
                          Cells cells) {
  const double theta = reference_theta(rows), resolution = reference_resolution(rows);
  HtmlTable table;
  table.caption = what + " at " + angle(theta) + ", map " + texels(resolution) + "; " + conditions(rows) + "." + kStar;
  table.head = head;
  for (const std::string& technique : names_in(rows, &StudyRow::technique)) {
    const StudyRow* row = find_row(rows, technique, resolution, theta);
    if (!row) continue;
    std::vector<std::string> line = cells(*row);
    line.insert(line.begin(), technique + (as_asked(*row) ? "" : "*"));
    table.rows.push_back(std::move(line));
  }
  return table;
}

}  // namespace

HtmlTable cause_table(const std::vector<StudyRow>& rows) {
  return reference_table(rows, "Wrong pixels by cause, in percent of compared pixels, and texel sizes m in pixels",
                         {"technique", "resolution", "acne", "leak", "outside", "m median", "m 95 %", "m largest", "m > 1 (%)"},
                         [](const StudyRow& r) -> std::vector<std::string> {
                           return {share(r, r.by_resolution),
                                   share(r, r.acne),
                                   share(r, r.leak),
                                   share(r, r.outside),
                                   shown(r.m_p50),
                                   shown(r.m_p95),
                                   shown(r.m_max),
                                   percent(r.undersampled)};
                         });
}

HtmlTable time_table(const std::vector<StudyRow>& rows) {
  return reference_table(
      rows,
      "Times in microseconds, medians: the analysis, of which the bodies R, H and H_R (timed beside it); map and eye by the wall "
      "clock until all is drawn, and by the driver's timer query. Spread: the quartiles' distance over the median, of analysis "
      "and "
      "map together;",
      {"technique", "analysis", "bodies", "map", "map, query", "eye", "eye, query", "runs", "spread (%)"},
      [](const StudyRow& r) -> std::vector<std::string> {
        return {shown(r.analysis_us), shown(r.bodies_us),     shown(r.map_us, 4),   shown(r.map_gpu_us, 4),
                shown(r.eye_us, 4),   shown(r.eye_gpu_us, 4), shown(r.timing_runs), shown(100 * r.timing_spread, 2)};
      });
}

HtmlTable equal_error_table(const std::vector<StudyRow>& rows) {
  const auto asked = rows_where(rows, [](const StudyRow& r) { return !std::isnan(r.equal_error_resolution); });
  const double resolution = reference_resolution(asked);
  const std::vector<double> angles = values_in(asked, &StudyRow::theta_deg);
  HtmlTable table;
  table.caption =
      "Equal-error resolution: the smallest uniform map with no larger error than the technique's of " + texels(resolution) +
      ", down from the largest map and then by bisection (errors jump with where texels lie, so that uniform itself is not "
      "exactly 1), and how "
      "many times larger its side is; none: not even the "
      "largest uniform map tried. Columns: angle between view and light, above 90\u00b0 behind; " +
      conditions(rows) + "." + kStar;
  table.head = angle_head("technique", angles);
  fill_over_angles(table, asked, resolution, angles, equal_error_text);
  return table;
}

HtmlTable best_plane_table(const std::vector<StudyRow>& rows) {
  const double resolution = reference_resolution(rows);
  const std::vector<double> angles = values_in(rows, &StudyRow::theta_deg);
  HtmlTable table;
  table.caption =
      "How far from the best single vanishing plane that a search over a coarse grid of visible points finds: 95th percentile of "
      "m, over all pixels, divided by "
      "that of best_plane (1: as good), map " +
      texels(resolution) +
      "; below 1: over all pixels better than the plane that is best on the grid. In best_plane's line its own m in pixels. " +
      "Columns: angle between view and light, above 90\u00b0 behind." + kStar;
  table.head = angle_head("technique", angles);
  const auto best = [&](double theta) { return find_row(rows, "best_plane", resolution, theta); };
  fill_over_angles(table, rows, resolution, angles, [&](const StudyRow* row) -> std::string {
    const StudyRow* b = row ? best(row->theta_deg) : nullptr;
    if (!row || !b) return "\u2013";
    return row->technique == "best_plane" ? shown(b, b->m_p95) + " px" : shown(row, row->m_p95 / b->m_p95);
  });
  return table;
}

HtmlTable closed_form_table(const std::vector<ClosedFormRow>& rows, const ClosedFormSetting& setting) {
  HtmlTable table;
  table.caption =
      "Largest values over all angles of the plot on the central line, n = " + shown(setting.near) +
      ", f = " + shown(setting.far) + ", phi = " + shown(setting.phi_deg) +
      "\u00b0, receivers fill the frustum: F and E = F sin(theta) in closed form and as measured in the maps, the largest "
      "relative difference of the two E, and the largest ratio of the map's E to the logarithmic lower bound "
      "sin(theta) ln(f/n) / tan(phi), which no map can go below. A dash: no closed form, or no map of this technique "
      "(plane_optimal: no flat receiver here).";
  table.head = {"technique", "max F, closed", "max F, maps", "max E, closed", "max E, maps", "difference", "over the bound"};
  std::vector<Technique> techniques;
  for (const ClosedFormRow& row : rows)
    if (techniques.empty() || techniques.back() != row.technique) techniques.push_back(row.technique);
  for (const Technique technique : techniques) {
    ClosedFormRow most{technique};
    double difference = kNone, over = kNone;
    for (const ClosedFormRow& row : rows) {
      if (row.technique != technique) continue;
      for (const auto column : {&ClosedFormRow::model_F, &ClosedFormRow::map_F, &ClosedFormRow::model_E, &ClosedFormRow::map_E})
        most.*column = std::fmax(most.*column, row.*column);
      difference = std::fmax(difference, std::abs(row.map_E / row.model_E - 1));
      over = std::fmax(over, row.map_E / row.bound_E);
    }
    table.rows.push_back({name_of(technique), shown(most.model_F, 4), shown(most.map_F, 4), shown(most.model_E, 4),
                          shown(most.map_E, 4), shown(difference, 2), shown(over, 3)});
  }
  return table;
}

HtmlTable cited_table(const CitedTable& cited) {
  HtmlTable table;
  table.caption = "Cited, not measured in this run. " + cited.source;
  table.head = angle_head("setup", cited.theta_deg);
  table.head.insert(table.head.begin() + 1, "time (\u00b5s)");
  for (const CitedTable::Row& row : cited.rows) {
    std::vector<std::string> line{row.setup, shown(row.microseconds)};
    for (const double m : row.m_p95) line.push_back(shown(m));
    table.rows.push_back(std::move(line));
  }
  return table;
}

HtmlTable slab_table(const std::vector<StudyRow>& slab, const std::string& what, bool behind) {
  const double resolution = reference_resolution(slab);
  std::vector<double> angles;
  for (const double theta : values_in(slab, &StudyRow::theta_deg))
    if ((theta > 90) == behind) angles.push_back(theta);
  HtmlTable table;
  table.caption = "psmlab's own, measured, " + what + ": 95th percentile of m in pixels on the same slab, sun " +
                  std::string(behind ? "behind" : "ahead of") + " the viewer, map " + texels(resolution) + "; " +
                  conditions(slab) + (slab.empty() ? "" : "; limit " + shown(slab[0].width / resolution)) +
                  "; time: median of the analysis over these angles." + kStar;
  table.head = angle_head("technique", angles);
  table.head.insert(table.head.begin() + 1, "time (\u00b5s)");
  fill_over_angles(table, slab, resolution, angles, [](const StudyRow* row) { return row ? shown(row, row->m_p95) : "\u2013"; });
  for (auto& line : table.rows) {
    std::vector<double> times;
    for (const double theta : angles)
      if (const StudyRow* row = find_row(slab, line[0], resolution, theta)) times.push_back(row->analysis_us);
    line.insert(line.begin() + 1, times.empty() ? "\u2013" : shown(median(times)));
  }
  return table;
}

HtmlTable far_table(const std::vector<StudyRow>& rows) {
  const std::vector<double> far = values_in(rows, &StudyRow::far);
  HtmlTable table;
  table.caption = "The same slab with the camera's far plane nearer: 95th percentile of m in pixels, sun ahead at " +
                  angle(reference_theta(rows)) + "; columns: depth of the farthest receiver over that of the nearest; " +
                  conditions(rows) + "." + kStar;
  table.head = {"technique"};
  for (const double f : far) {
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const StudyRow& r) { return r.far == f; });
    table.head.push_back(shown(row->far / row->near));
  }
  for (const std::string& technique : names_in(rows, &StudyRow::technique)) {
    std::vector<std::string> line{technique};
    for (const double f : far) {
      const auto row =
          std::find_if(rows.begin(), rows.end(), [&](const StudyRow& r) { return r.far == f && r.technique == technique; });
      line.push_back(row == rows.end() ? "\u2013" : shown(&*row, row->m_p95));
    }
    table.rows.push_back(std::move(line));
  }
  return table;
}

HtmlTable hard_case_table(const std::vector<MeasuredCase>& cases) {
  HtmlTable table;
  table.caption =
      "Hard cases: the answer in float and in double, the exact one, the error on a map of 1,024 texels, the verdict, and the "
      "time "
      "of one evaluation in double (nanoseconds).";
  table.head = {"case", "no.", "float", "double", "exact", "texels, float", "texels, double", "verdict", "ns"};
  for (const MeasuredCase& c : cases)
    table.rows.push_back({c.row.name + ": " + c.row.computed, std::to_string(c.row.number),
                          c.row.in_float ? answer(c.in_float) : "\u2013", answer(c.in_double), shown(c.row.exact.value, 9),
                          shown(c.in_float.texels, 2), shown(c.in_double.texels, 2), name_of(c.verdict),
                          shown(c.double_seconds * 1e9)});
  return table;
}

HtmlTable machine_table(const std::vector<StudyRow>& rows) {
  HtmlTable table;
  table.caption = "What the rows were measured on; rows.csv names the machine of each.";
  table.head = {"processor", "rows", "compiler", "OpenGL", "truth"};
  for (const StudyRow& row : rows) {
    const std::vector<std::string> line{row.cpu, "1", row.compiler, row.opengl, row.tracer};
    const auto same = [&](const std::vector<std::string>& other) {
      return other[0] == line[0] && other[2] == line[2] && other[3] == line[3] && other[4] == line[4];
    };
    const auto found = std::find_if(table.rows.begin(), table.rows.end(), same);
    if (found == table.rows.end())
      table.rows.push_back(line);
    else
      (*found)[1] = std::to_string(std::stoul((*found)[1]) + 1);
  }
  return table;
}

}  // namespace psm
