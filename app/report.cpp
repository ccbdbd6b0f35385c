// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "app/assets.h"
#include "app/command_line.h"
#include "app/commands.h"
#include "app/machine.h"
#include "app/numbers.h"
#include "app/progress.h"
#include "app/study_runner.h"
#include "figure/report.h"
#include "measure/journal.h"

namespace psm {
namespace {

namespace fs = std::filesystem;

/// The I-th of N, from 0: neighbouring runs, which share truth and uniform maps.
struct Shard {
  std::size_t index = 0, count = 1;
  bool has(std::size_t run, std::size_t runs) const { return run * count / runs == index; }
  std::string file() const { return std::to_string(index + 1) + "-of-" + std::to_string(count) + ".csv"; }
};

Result<Shard> parse_shard(const std::optional<std::string>& text) {
  if (!text) return Shard{};
  const std::vector<std::string> parts = split(*text, '/');
  const auto index = number_from_text(parts[0]), count = number_from_text(parts.back());
  const auto whole = [](double x) { return std::trunc(x) == x && x >= 1 && x <= 10000; };
  if (parts.size() != 2 || !index || !count || !whole(*index) || !whole(*count) || *index > *count)
    return flag_error("--shard", *text, "I/N with whole numbers 1 <= I <= N <= 10000");
  return Shard{std::size_t(*index) - 1, std::size_t(*count)};
}

fs::path rows_folder(const fs::path& report) { return report / "rows"; }

std::optional<InputError> make_folders(const std::string& out) {
  std::error_code error;
  if (!out.empty()) fs::create_directories(rows_folder(out), error);
  if (out.empty() || error) return flag_error("--out", out, "a folder that exists or can be made");
  return std::nullopt;
}

/// By the fingerprint that their rows have.
using Studies = std::map<std::string, Study>;

void add_study(Studies& studies, bool quick) {
  Study study = default_study(quick);
  studies.emplace(fingerprint(study, PSMLAB_VERSION), std::move(study));
}

RowCheck row_of_one_of(const Studies& studies) {
  return [&studies](const StudyRow& row) -> std::optional<std::string> {
    const auto study = studies.find(row.study);
    if (study == studies.end())
      return "a row of another study, " + row.study +
             "; allowed: rows of the same build of psmlab, and to go on: of the same command";
    if (!is_row_of(study->second, row))
      return "not what run " + number_text(row.run) + " of its study asks for; allowed: rows as psmlab wrote them";
    return std::nullopt;
  };
}

/// What this shard has still to measure.
std::vector<std::size_t> missing_runs(const Study& study, const Shard& shard, const std::vector<StudyRow>& finished) {
  std::set<std::size_t> have;
  for (const StudyRow& row : finished) have.insert(std::size_t(row.run));
  std::vector<std::size_t> missing;
  for (std::size_t run = 0; run < study.runs.size(); ++run)
    if (shard.has(run, study.runs.size()) && !have.count(run)) missing.push_back(run);
  return missing;
}

/// False where the user interrupted it.
Result<bool> measure_runs(StudyRunner& runner, const std::vector<std::size_t>& runs, const fs::path& journal_file) {
  auto journal = Journal::open(journal_file);
  if (!journal) return journal.error();
  const Interruptible interruptible;
  Progress progress(runs.size());
  for (const std::size_t run : runs) {
    if (Interruptible::asked()) return false;
    if (auto error = journal->append(runner.measure(run))) return *error;
    progress.finished_one();
  }
  return true;
}

Result<CitedTable> cited() {
  const fs::path file = assets_folder() / "reference" / "one_scene.csv";
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return read_cited_table(text.str(), file.string());
}

std::optional<InputError> write_report(const std::vector<StudyRow>& rows, std::size_t planned, const std::string& out) {
  ReportInput input;
  input.rows = rows;
  input.planned = planned;
  std::vector<double> theta;
  for (int degrees = 5; degrees <= 90; degrees += 5) theta.push_back(degrees);
  input.closed_forms = compare_with_closed_forms(input.closed_form_setting, theta);
  const auto table = cited();
  if (!table) return table.error();
  input.cited = *table;
  input.hard_cases = measure_hard_cases();
  input.machine = this_machine();
  for (const ReportFile& file : make_report(input))
    if (auto error = write_file_atomically(fs::path(out) / file.name, file.bytes)) return error;
  return std::nullopt;
}

int merge(const ReportArguments& arguments) {
  if (arguments.quick || arguments.shard)
    return bad_input({"--merge: with --quick or --shard; allowed: alone, since it measures nothing"});
  std::vector<fs::path> folders;
  for (const std::string& folder : arguments.merge) {
    std::error_code error;
    if (!fs::is_directory(rows_folder(folder), error))
      return bad_input(flag_error("--merge", folder, "the folder of a report, with its rows"));
    folders.push_back(rows_folder(folder));
  }
  folders.push_back(rows_folder(arguments.out));  // what is there already must belong to the same study
  Studies studies;
  for (const bool quick : {false, true}) add_study(studies, quick);
  const auto rows = read_journals(folders, row_of_one_of(studies));
  if (!rows) return bad_input(rows.error());
  const std::size_t planned = rows->empty() ? 0 : studies.at(rows->front().study).runs.size();
  if (auto error = make_folders(arguments.out)) return bad_input(*error);
  // As a journal of the new report, so that it can be merged, and gone on with, in its turn.
  std::string journal = csv_header();
  for (const StudyRow& row : *rows) journal += csv_line(row);
  if (auto error = write_file_atomically(rows_folder(arguments.out) / "merged.csv", journal)) return bad_input(*error);
  if (auto error = write_report(*rows, planned, arguments.out)) return bad_input(*error);
  return finish_printing(print((fs::path(arguments.out) / "index.html").string() + "\n"));
}

int measure_and_write(const ReportArguments& arguments) {
  const auto shard = parse_shard(arguments.shard);
  if (!shard) return bad_input(shard.error());
  Studies studies;
  add_study(studies, arguments.quick);
  const Study& study = studies.begin()->second;
  const auto finished = read_journals({rows_folder(arguments.out)}, row_of_one_of(studies));
  if (!finished) return bad_input(finished.error());
  if (auto error = make_folders(arguments.out)) return bad_input(*error);
  bool complete = true;
  if (const auto missing = missing_runs(study, *shard, *finished); !missing.empty()) {
    const auto runner = StudyRunner::create(study);
    if (!runner) return other_failure(runner.error());
    const auto measured = measure_runs(**runner, missing, rows_folder(arguments.out) / shard->file());
    if (!measured) return bad_input(measured.error());
    complete = *measured;
  }
  const auto rows = read_journals({rows_folder(arguments.out)}, row_of_one_of(studies));
  if (!rows) return bad_input(rows.error());
  if (auto error = write_report(*rows, study.runs.size(), arguments.out)) return bad_input(*error);
  if (!complete) {
    complain("interrupted: " + std::to_string(rows->size()) + " of " + std::to_string(study.runs.size()) +
             " runs are measured; the same command goes on");
    return kOtherFailure;
  }
  return finish_printing(print((fs::path(arguments.out) / "index.html").string() + "\n"));
}

}  // namespace

int report(const ReportArguments& arguments) { return arguments.merge.empty() ? measure_and_write(arguments) : merge(arguments); }

}  // namespace psm
