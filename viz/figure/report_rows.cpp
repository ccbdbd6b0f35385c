// SPDX-License-Identifier: GPL-3.0-or-later
// Rows chosen and shown.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "figure/report_parts.h"

namespace psm {
namespace {

struct Style {
  const char* technique;
  std::uint32_t color;
  const char* dash;
  bool in_plots;
};

// Okabe and Ito's colours as lines on white, as in viz/draw/palette.cpp: black the uniform map, vermillion the PSM of 2002, blue
// the warps, green the planes found for the scene.
constexpr std::array kStyles{Style{"uniform", 0x222222, "", true},
                             Style{"psm", 0xD55E00, "", true},
                             Style{"psm_recipe", 0xD55E00, "10 5", false},
                             Style{"psm_divided", 0xD55E00, "3 5", false},
                             Style{"psm_two_maps", 0xD55E00, "1 4", false},
                             Style{"lispsm", 0x0072B2, "10 5", true},
                             Style{"lispsm_reference", 0x0072B2, "3 5", false},
                             Style{"gmnpr", 0x0072B2, "", true},
                             Style{"glpr", 0x2F8FC6, "12 4 3 4", false},
                             Style{"minimax", 0x2F8FC6, "3 5", false},
                             Style{"minimax_frustum", 0x2F8FC6, "", false},
                             Style{"plane_optimal", 0x009E73, "10 5", true},
                             Style{"best_plane", 0x009E73, "", true}};

const Style* style_of(const std::string& technique) {
  const auto found = std::find_if(kStyles.begin(), kStyles.end(), [&](const Style& s) { return technique == s.technique; });
  return found == kStyles.end() ? nullptr : &*found;
}

template <class Value>
std::vector<Value> different(const std::vector<StudyRow>& rows, Value StudyRow::*column) {
  std::vector<Value> values;
  for (const StudyRow& row : rows)
    if (std::find(values.begin(), values.end(), row.*column) == values.end()) values.push_back(row.*column);
  return values;
}

/// The value that is closest to a wanted one.
double closest(const std::vector<double>& values, double wanted) {
  const auto nearer = [&](double a, double b) { return std::abs(a - wanted) < std::abs(b - wanted); };
  return values.empty() ? wanted : *std::min_element(values.begin(), values.end(), nearer);
}

}  // namespace

std::vector<StudyRow> rows_where(const std::vector<StudyRow>& rows, const RowTest& test) {
  std::vector<StudyRow> chosen;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(chosen), test);
  return chosen;
}

std::vector<std::string> names_in(const std::vector<StudyRow>& rows, std::string StudyRow::*column) {
  return different(rows, column);
}
std::vector<double> values_in(const std::vector<StudyRow>& rows, double StudyRow::*column) { return different(rows, column); }

const StudyRow* find_row(const std::vector<StudyRow>& rows, const std::string& technique, double resolution, double theta_deg) {
  for (const StudyRow& row : rows)
    if (row.technique == technique && row.resolution == resolution && row.theta_deg == theta_deg) return &row;
  return nullptr;
}

bool as_asked(const StudyRow& row) { return row.technique == row.technique_used; }

std::string shown(double value, int digits) {
  if (std::isnan(value)) return "\u2013";
  if (std::isinf(value)) return value > 0 ? "\u221e" : "-\u221e";
  char text[40];
  if (std::abs(value) >= std::pow(10.0, digits))
    std::snprintf(text, sizeof text, "%.0f", value);  // no exponent, for tables
  else
    std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

std::string shown(const StudyRow* row, double value, int digits) {
  if (!row) return "\u2013";
  return shown(value, digits) + (as_asked(*row) ? "" : "*");
}

std::string percent(double fraction) {
  if (!std::isfinite(fraction)) return shown(fraction);
  char text[40];
  std::snprintf(text, sizeof text, std::abs(fraction) < 0.1 ? "%.3f" : "%.1f", 100 * fraction);
  return text;
}

std::string angle(double theta_deg) { return shown(theta_deg, 4) + "\u00b0"; }

PlotCurve technique_curve(const std::string& technique) {
  PlotCurve curve;
  curve.label = technique;
  if (const Style* style = style_of(technique)) curve.color = style->color, curve.dash = style->dash;
  return curve;
}

bool in_plots(const std::string& technique) {
  const Style* style = style_of(technique);
  return style && style->in_plots;
}

double reference_theta(const std::vector<StudyRow>& rows) { return closest(values_in(rows, &StudyRow::theta_deg), 60); }
double reference_resolution(const std::vector<StudyRow>& rows) { return closest(values_in(rows, &StudyRow::resolution), 1024); }

std::string conditions(const std::vector<StudyRow>& rows) {
  if (rows.empty()) return "nothing measured yet";
  const StudyRow& row = rows.front();
  std::string text = "image " + shown(row.width, 5) + " \u00d7 " + shown(row.height, 5);
  const auto renderers = names_in(rows, &StudyRow::opengl);
  return text + "; " + (renderers.size() == 1 ? renderers[0].substr(0, renderers[0].find(" (")) : "several machines");
}

}  // namespace psm
