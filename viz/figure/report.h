// SPDX-License-Identifier: GPL-3.0-or-later
// The speed-against-error study as files: rows, plots, and one page that holds everything.
#pragma once

#include <string>
#include <vector>

#include "measure/closed_form.h"
#include "measure/hard_case_report.h"
#include "measure/study_row.h"

namespace psm {

/// Numbers of others, as they were published or measured elsewhere.
struct CitedTable {
  std::string source;             // in a few sentences
  std::vector<double> theta_deg;  // of the columns
  struct Row {
    std::string setup;
    double microseconds = kNone;
    std::vector<double> m_p95;
  };
  std::vector<Row> rows;
};

/// From a CSV whose first lines, which start with '#', tell the source. An error names `name` and the line.
Result<CitedTable> read_cited_table(const std::string& csv, const std::string& name);

struct ReportInput {
  std::vector<StudyRow> rows;  // by run
  std::size_t planned = 0;     // runs of the whole study
  std::vector<ClosedFormRow> closed_forms;
  ClosedFormSetting closed_form_setting;
  CitedTable cited;
  std::vector<MeasuredCase> hard_cases;
  Machine machine;  // that the hard cases and the closed forms ran on
};

struct ReportFile {
  std::string name, bytes;
};

/// index.html, rows.csv and the plots as SVG.
std::vector<ReportFile> make_report(const ReportInput& input);

}  // namespace psm
