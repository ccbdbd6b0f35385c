// SPDX-License-Identifier: GPL-3.0-or-later
// One run of a speed-against-error study: the error of one shadow map, and what it cost. Its columns are declared once, in the
// table of study_row.cpp: CSV, JSON and journals come from it.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/result.h"

namespace psm {

/// A number that was not measured, or does not exist.
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

struct StudyRow {
  // Which run: of which program and study, and its place there.
  std::string version, study;
  double run = kNone;

  // Under which conditions.
  std::string scene, technique;
  double resolution = kNone, theta_deg = kNone, width = kNone, height = kNone, camera_far = kNone;
  double light_radius = kNone, depth_bias = kNone, slope_bias = kNone, normal_bias = kNone, filter_size = kNone;
  std::string cull, filter;

  // What the technique did: n, f, phi, rho as in Analysis; codes of the notes, separated by blanks.
  std::string technique_used, notes;
  double near = kNone, far = kNone, phi_deg = kNone, rho = kNone, texels = kNone;

  // Error in pixels of the image: ShadowError and TexelStatistics.
  double compared = kNone, error_fraction = kNone, wrongly_lit = kNone, wrongly_dark = kNone;
  double outside = kNone, by_resolution = kNone, acne = kNone, leak = kNone, lit_difference = kNone;
  double m_mean = kNone, m_p50 = kNone, m_p95 = kNone, m_max = kNone, undersampled = kNone;
  // On the central line: the two-dimensional model's largest F and E, and E as the map has it.
  double model_F = kNone, model_E = kNone, line_E = kNone;
  // The uniform map with no larger error: texels along its side; infinite: none as large as the study goes.
  double equal_error_resolution = kNone;

  // Microseconds, medians of `timing_runs` (eye: of up to 3); `spread`: the quartiles' distance over the median, of analysis and
  // map together.
  double analysis_us = kNone, bodies_us = kNone, map_us = kNone, map_gpu_us = kNone, eye_us = kNone, eye_gpu_us = kNone;
  double timing_runs = kNone, timing_spread = kNone;

  // On which machine.
  std::string cpu, compiler, opengl, tracer;

  /// What the shadows of a frame cost. The eye's image costs the same with any map.
  double shadow_us() const { return analysis_us + map_us; }
};

struct StudyColumn {
  std::string name;
  std::variant<std::string StudyRow::*, double StudyRow::*> member;
  std::string help;         // what it is, with its unit
  bool of_machine = false;  // the same in all rows of one machine
  bool repeatable = true;   // the same whenever the same program measures the same run
};
const std::vector<StudyColumn>& study_columns();

/// Lines of CSV, each with its newline. Numbers round-trip; what does not exist is empty.
std::string csv_header();
std::string csv_line(const StudyRow& row);

/// From a line without its newline; nothing where it is not a whole row.
std::optional<StudyRow> row_from_csv(const std::string& line);

/// One object: "psmlab": 1, "machine", "rows". What does not exist is null.
std::string rows_to_json(const std::vector<StudyRow>& rows);

}  // namespace psm
