// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the report; private to viz/figure.
#pragma once

#include <functional>

#include "figure/html.h"
#include "figure/plot.h"
#include "figure/report.h"

namespace psm {

/// Rows by what they were asked for. Their order stays.
using RowTest = std::function<bool(const StudyRow&)>;
std::vector<StudyRow> rows_where(const std::vector<StudyRow>& rows, const RowTest& test);

/// Different values of a column, in the order of the rows.
std::vector<std::string> names_in(const std::vector<StudyRow>& rows, std::string StudyRow::*column);
std::vector<double> values_in(const std::vector<StudyRow>& rows, double StudyRow::*column);

/// The row of this technique, resolution and angle; null where it was not measured.
const StudyRow* find_row(const std::vector<StudyRow>& rows, const std::string& technique, double resolution, double theta_deg);

/// What was asked for is what was used: the technique was not replaced by another.
bool as_asked(const StudyRow& row);

/// `digits` significant ones; a dash for what does not exist.
std::string shown(double value, int digits = 3);
/// Of a row; with a star where the technique was replaced.
std::string shown(const StudyRow* row, double value, int digits = 3);
std::string percent(double fraction);
std::string angle(double theta_deg);

/// Colour and dash of a technique's curves; the family has the colour, the member the dash.
PlotCurve technique_curve(const std::string& technique);
/// Those that a plot can hold and still be read.
bool in_plots(const std::string& technique);

/// The angle and the resolution at which plots and tables of one angle or one resolution are made.
double reference_theta(const std::vector<StudyRow>& rows);
double reference_resolution(const std::vector<StudyRow>& rows);

/// "640 x 360 pixels, ..., GL renderer": under which conditions the rows were measured.
std::string conditions(const std::vector<StudyRow>& rows);

// `rows`: of one scene.
Plot error_plot(const std::vector<StudyRow>& rows, bool against_time);
Plot equal_error_plot(const std::vector<StudyRow>& rows);
Plot texel_size_plot(const std::vector<StudyRow>& slab);
Plot closed_form_plot(const std::vector<ClosedFormRow>& rows, const ClosedFormSetting& setting);

HtmlTable error_table(const std::vector<StudyRow>& rows);
HtmlTable cause_table(const std::vector<StudyRow>& rows);
HtmlTable time_table(const std::vector<StudyRow>& rows);
HtmlTable equal_error_table(const std::vector<StudyRow>& rows);
HtmlTable best_plane_table(const std::vector<StudyRow>& rows);
HtmlTable closed_form_table(const std::vector<ClosedFormRow>& rows, const ClosedFormSetting& setting);
HtmlTable cited_table(const CitedTable& cited);
/// `what` goes before the numbers' description: which slab this is.
HtmlTable slab_table(const std::vector<StudyRow>& slab, const std::string& what, bool behind);
HtmlTable far_table(const std::vector<StudyRow>& rows);
HtmlTable hard_case_table(const std::vector<MeasuredCase>& cases);
HtmlTable machine_table(const std::vector<StudyRow>& rows);

}  // namespace psm
