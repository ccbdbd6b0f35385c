// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measure.h"

#include <cmath>
#include <string>

#include "app/command_line.h"
#include "app/machine.h"
#include "app/numbers.h"
#include "app/progress.h"
#include "app/study_runner.h"

namespace psm {
namespace {

constexpr std::size_t kMostRuns = 100000;

Result<std::vector<Technique>> parse_techniques(const std::optional<std::string>& names, const Experiment& experiment) {
  if (!names) return std::vector<Technique>{experiment.shadow.technique};
  if (*names == "all") return techniques_to_compare();
  std::vector<Technique> techniques;
  for (const std::string& name : split(*names, ',')) {
    const auto technique = technique_from_name(name);
    std::string allowed = "all, or a comma-separated list of:";
    for (const std::string& known : technique_names()) allowed += " " + known;
    if (!technique) return flag_error("--techniques", name, allowed);
    techniques.push_back(*technique);
  }
  return techniques;
}

/// Each as --set would take it for this member.
template <class Value>
Result<std::vector<Value>> parse_members(const char* flag, const std::optional<std::string>& text, const char* path,
                                         const Experiment& experiment, Value (*read)(const Experiment&)) {
  std::vector<Value> values;
  for (const std::string& part : text ? split(*text, ',') : std::vector<std::string>()) {
    Experiment changed = experiment;
    if (const auto error = set_field(changed, std::string(path) + "=" + part))
      return InputError{std::string(flag) + ": " + one_line(error->text)};
    values.push_back(read(changed));
  }
  return values;
}

Result<std::vector<std::optional<double>>> parse_angles(const std::optional<std::string>& text, const Experiment& experiment) {
  using Angles = std::vector<std::optional<double>>;
  if (!text) return Angles{std::nullopt};
  if (experiment.light.type != LightType::directional)
    return flag_error("--theta-deg", *text, "only with a directional light (--set light.type=directional)");
  const auto angles = parse_theta_deg(*text);
  if (!angles) return angles.error();
  return Angles(angles->begin(), angles->end());
}

Result<Study> parse_study(const MeasureArguments& arguments) {
  auto loaded = load(arguments.experiment);
  if (!loaded) return loaded.error();
  const Experiment& x = loaded->experiment;
  if (const auto error = check_rays(x.image, "measure")) return *error;
  const auto techniques = parse_techniques(arguments.techniques, x);
  if (!techniques) return techniques.error();
  const auto resolutions = parse_members<int>("--resolutions", arguments.resolutions, "shadow.resolution", x,
                                              [](const Experiment& e) { return e.shadow.resolution; });
  if (!resolutions) return resolutions.error();
  const auto far =
      parse_members<double>("--far", arguments.far, "camera.far", x, [](const Experiment& e) { return e.camera.far; });
  if (!far) return far.error();
  const auto angles = parse_angles(arguments.theta_deg, x);
  if (!angles) return angles.error();

  Sweep sweep{*angles, {far->begin(), far->end()}, *techniques, *resolutions, {}};
  if (sweep.far.empty()) sweep.far = {std::nullopt};
  if (sweep.resolutions.empty()) sweep.resolutions = {x.shadow.resolution};
  const std::size_t runs = sweep.theta_deg.size() * sweep.far.size() * sweep.techniques.size() * sweep.resolutions.size();
  if (runs > kMostRuns) return InputError{"measure: " + std::to_string(runs) + " runs; allowed: at most 100000"};
  Study study;
  study.scenes.push_back({loaded->scene.id, *loaded});
  add_runs(study, 0, sweep);
  for (StudyRun& run : study.runs) run.equal_error = arguments.equal_error;
  return study;
}

int measure_runs(const MeasureArguments& arguments) {
  const auto study = parse_study(arguments);
  if (!study) return bad_input(study.error());
  const auto runner = StudyRunner::create(*study);
  if (!runner) return other_failure(runner.error());
  const Interruptible interruptible;
  const std::size_t runs = study->runs.size();
  std::vector<StudyRow> rows;
  bool printed = !arguments.csv || print(csv_header());
  {
    Progress progress(runs);
    while (rows.size() < runs && printed && !Interruptible::asked()) {
      rows.push_back((*runner)->measure(rows.size()));
      if (arguments.csv) printed = print(csv_line(rows.back()));
      progress.finished_one();
    }
  }
  if (!arguments.csv) printed = print(rows_to_json(rows));
  const int code = finish_printing(printed);
  if (code != kDone || rows.size() == runs) return code;
  complain("interrupted: " + std::to_string(rows.size()) + " of " + std::to_string(runs) + " runs are measured and printed");
  return kOtherFailure;
}

int measure_hard_cases_only(const MeasureArguments& arguments) {
  const auto cases = measure_hard_cases();
  const auto format = arguments.csv ? hard_cases_csv : arguments.json ? hard_cases_json : hard_cases_text;
  return finish_printing(print(format(cases, this_machine())));
}

}  // namespace

int measure(const MeasureArguments& arguments) {
  if (arguments.csv && arguments.json) return bad_input({"--csv, --json: both were given; allowed: one of them"});
  if (!arguments.hard_cases) return measure_runs(arguments);
  const ExperimentArguments& experiment = arguments.experiment;
  if (experiment.source || !experiment.overrides.empty() || arguments.techniques || arguments.resolutions ||
      arguments.theta_deg || arguments.far || arguments.equal_error)
    return bad_input({"--hard-cases: together with an experiment or a sweep; allowed: alone, or with --csv or --json"});
  return measure_hard_cases_only(arguments);
}

}  // namespace psm
