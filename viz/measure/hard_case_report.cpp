// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/hard_case_report.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "scene/experiment.h"

namespace psm {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_of(const Compute& compute, int times) {
  volatile double sink = 0;
  const auto start = Clock::now();
  for (int i = 0; i < times; ++i) sink = compute().value;
  (void)sink;
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The median of 9 batches, each long enough for the clock.
double median_seconds(const Compute& compute) {
  constexpr double kBatch = 2e-5;
  int times = 1;
  while (seconds_of(compute, times) < kBatch && times < (1 << 20)) times *= 2;
  std::array<double, 9> batches{};
  for (double& b : batches) b = seconds_of(compute, times) / times;
  std::nth_element(batches.begin(), batches.begin() + 4, batches.end());
  return batches[4];
}

std::string digits(double x, int significant) {
  if (std::isnan(x)) return "nan";  // never with a sign
  char text[64];
  std::snprintf(text, sizeof text, "%.*g", significant, x);
  return text;
}

std::string answer_text(const HardCase& row, const CaseAnswer& a, int significant) {
  if (a.named.empty()) return digits(a.value, significant);
  return row.demand == Demand::said ? "said" : "refused";
}

std::string exact_text(const HardCase& row) {
  if (row.demand == Demand::said) return "said";
  if (row.demand == Demand::refused) return "refused";
  return row.exact.kind == ExactKind::none ? "-" : digits(row.exact.value, 17);
}

const char* exact_by(const HardCase& row) {
  constexpr const char* names[] = {"-", "rational", "100 digits"};
  return row.exact.settled ? names[int(row.exact.kind)] : "UNSETTLED";
}

std::string bounds_text(const HardCase& row) {
  const std::string bound = digits(row.double_bound, 2);
  return row.in_float && row.float_bound != row.double_bound ? bound + " (" + digits(row.float_bound, 2) + ")" : bound;
}

/// What must hold of the double, and in brackets of the float where less will do.
std::string demand_text(const HardCase& row) {
  switch (row.demand) {
    case Demand::equals:
      return std::string(row.exact.value == 0 ? "exact" : "relative") + " +- " + bounds_text(row);
    case Demand::texels:
      return "texels <= " + bounds_text(row);
    case Demand::at_most:
      return "<= " + bounds_text(row);
    case Demand::above:
      return "> " + bounds_text(row);
    default:
      return row.reason;
  }
}

/// The same with the least of words: +- is relative unless the answer is 0, and texels stand in their columns.
std::string short_demand(const HardCase& row) {
  constexpr const char* signs[] = {"+- ", "texels <= ", "<= ", "> "};
  return row.demand < Demand::said ? signs[int(row.demand)] + bounds_text(row) : "by name";
}

std::string time_text(double seconds) {
  if (!(seconds > 0)) return "-";
  if (seconds < 1e-6) return digits(seconds * 1e9, 3) + " ns";
  return seconds < 1e-3 ? digits(seconds * 1e6, 3) + " us" : digits(seconds * 1e3, 3) + " ms";
}

std::string texels_text(double texels) { return std::isnan(texels) ? "-" : digits(texels, 2); }

/// Without a float path there is no answer to show.
std::string float_text(const MeasuredCase& c) { return c.row.in_float ? answer_text(c.row, c.in_float, 9) : "-"; }

struct Texels {
  double in_float, two_stages, in_double;
};
Texels texels_of(const MeasuredCase& c) { return {c.in_float.texels, c.two_stages.texels, c.in_double.texels}; }

constexpr int kColumns = 12;
using Line = std::array<std::string, kColumns>;

Line group_headings() { return {"", "", "", "exact", "must be:", "texels:", "float,", "", "time:", "", "100", ""}; }

Line headings() {
  return {"float",   "double", "exact", "known by", "double (float)", "float",
          "2 matr.", "double", "float", "double",   "digits",         "verdict"};
}

Line line_of(const MeasuredCase& c) {
  const Texels t = texels_of(c);
  return {float_text(c),
          answer_text(c.row, c.in_double, 17),
          exact_text(c.row),
          exact_by(c.row),
          short_demand(c.row),
          texels_text(t.in_float),
          texels_text(t.two_stages),
          texels_text(t.in_double),
          time_text(c.float_seconds),
          time_text(c.double_seconds),
          time_text(c.row.exact.seconds),
          name_of(c.verdict)};
}

/// Words to the left, numbers to the right.
std::vector<std::string> aligned(const std::vector<Line>& lines) {
  constexpr bool to_the_left[kColumns] = {false, true, true, true, true, false, false, false, false, false, false, true};
  std::array<std::size_t, kColumns> width{};
  for (const Line& line : lines)
    for (int i = 0; i < kColumns; ++i) width[i] = std::max(width[i], line[i].size());
  std::vector<std::string> texts;
  for (const Line& line : lines) {
    std::string row;
    for (int i = 0; i < kColumns; ++i) {
      const std::string pad(width[i] - line[i].size(), ' ');
      row += (i ? " " : "") + (to_the_left[i] ? line[i] + pad : pad + line[i]);
    }
    texts.push_back(row.substr(0, row.find_last_not_of(' ') + 1));
  }
  return texts;
}

/// "13  w = 1e-7", once for all quantities of one case.
std::string heading_of(const HardCase& row) {
  const std::string number = std::to_string(row.number);
  return std::string(2 - number.size(), ' ') + number + "  " + row.name + "\n";
}

std::string quoted_csv(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

std::string quoted_json(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) >= ' ') out += c;
  }
  return out + "\"";
}

/// Round-trips; infinities are strings, what is no number is null.
std::string json_number(double x) {
  if (std::isnan(x)) return "null";
  return std::isinf(x) ? (x > 0 ? "\"inf\"" : "\"-inf\"") : number_text(x);
}

std::string csv_number(double x) { return std::isnan(x) ? "" : number_text(x); }

std::string json_answer(const char* name, const Compute& compute, const CaseAnswer& a, double seconds) {
  std::string text = std::string("\"") + name + "\": ";
  if (!compute) return text + "null";
  text += "{\"value\": " + json_number(a.value);
  text += ", \"named\": " + (a.named.empty() ? "null" : quoted_json(a.named));
  text += ", \"texels\": " + json_number(a.texels);
  return text + ", \"seconds\": " + json_number(seconds) + "}";
}

std::string json_row(const MeasuredCase& c) {
  std::string text = "{\"case\": " + std::to_string(c.row.number) + ", \"name\": " + quoted_json(c.row.name);
  text += ", \"computed\": " + quoted_json(c.row.computed);
  text += std::string(", \"form\": ") + (c.row.form == Form::ours ? "\"ours\"" : "\"naive\"");
  text += ", " + json_answer("float", c.row.in_float, c.in_float, c.float_seconds);
  text += ", " + json_answer("double", c.row.in_double, c.in_double, c.double_seconds);
  text += ", \"two_stage_texels\": " + json_number(c.two_stages.texels);
  text += ", \"exact\": " + json_number(c.row.exact.value) +
          ", \"exact_by\": " + (c.row.exact.kind == ExactKind::none ? "null" : quoted_json(exact_by(c.row)));
  text += ", \"exact_seconds\": " + json_number(c.row.exact.seconds);
  text += ", \"demand\": " + quoted_json(demand_text(c.row)) + ", \"verdict\": " + quoted_json(name_of(c.verdict));
  return text + "}";
}

}  // namespace

std::vector<MeasuredCase> measure_hard_cases() {
  std::vector<MeasuredCase> cases;
  for (HardCase& row : hard_cases()) {
    MeasuredCase c;
    if (row.in_float) {
      c.in_float = row.in_float();
      c.float_seconds = median_seconds(row.in_float);
    }
    if (row.two_stages) c.two_stages = row.two_stages();
    c.in_double = row.in_double();
    c.double_seconds = median_seconds(row.in_double);
    c.verdict = judge(row, c.in_float, c.in_double);
    c.row = std::move(row);
    cases.push_back(std::move(c));
  }
  return cases;
}

std::string hard_cases_text(const std::vector<MeasuredCase>& cases, const Machine& machine) {
  std::vector<Line> lines{group_headings(), headings()};
  std::array<int, 6> count{};
  for (const MeasuredCase& c : cases) {
    lines.push_back(line_of(c));
    ++count[int(c.verdict)];
  }
  std::string text =
      "# " + machine.cpu + "; " + machine.compiler + "; " + std::to_string(cases.size()) +
      " rows; a time is that of the whole row, the median of 9 batches\n"
      "# texels of error on a map of 1,024; 2 matr.: two matrices for each vertex; +- is relative unless the answer is 0\n";
  const std::vector<std::string> rows = aligned(lines);
  text += rows[0] + "\n" + rows[1] + "\n";
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (i == 0 || cases[i].row.number != cases[i - 1].row.number || cases[i].row.name != cases[i - 1].row.name)
      text += heading_of(cases[i].row);
    text += "      " + cases[i].row.computed + (cases[i].row.reason.empty() ? "" : ": " + cases[i].row.reason) + "\n" +
            rows[i + 2] + "\n";
  }
  text += "#";
  for (int v = 0; v < int(count.size()); ++v)
    text += std::string(v ? ", " : " ") + name_of(Verdict(v)) + ": " + std::to_string(count[v]);
  return text + "\n";
}

std::string hard_cases_csv(const std::vector<MeasuredCase>& cases, const Machine& machine) {
  std::string text =
      "case,name,computed,form,float,double,exact,exact_by,demand,float_texels,two_stage_texels,double_texels,verdict,"
      "float_seconds,double_seconds,exact_seconds,cpu,compiler\n";
  for (const MeasuredCase& c : cases) {
    const Texels t = texels_of(c);
    const auto value = [](const CaseAnswer& a) { return a.named.empty() ? csv_number(a.value) : a.named; };
    text += std::to_string(c.row.number) + "," + quoted_csv(c.row.name) + "," + quoted_csv(c.row.computed) + ",";
    text += std::string(c.row.form == Form::ours ? "ours" : "naive") + "," + (c.row.in_float ? value(c.in_float) : "") + ",";
    text += value(c.in_double) + "," + csv_number(c.row.exact.value) + "," + exact_by(c.row) + ",";
    text += quoted_csv(demand_text(c.row)) + ",";
    for (const double x : {t.in_float, t.two_stages, t.in_double}) text += csv_number(x) + ",";
    text += std::string(name_of(c.verdict)) + "," + (c.row.in_float ? csv_number(c.float_seconds) : "") + ",";
    text += csv_number(c.double_seconds) + "," + csv_number(c.row.exact.seconds) + "," + quoted_csv(machine.cpu) + "," +
            quoted_csv(machine.compiler) + "\n";
  }
  return text;
}

std::string hard_cases_json(const std::vector<MeasuredCase>& cases, const Machine& machine) {
  std::string text = "{\n  \"psmlab\": 1,\n  \"machine\": {\"cpu\": " + quoted_json(machine.cpu) +
                     ", \"compiler\": " + quoted_json(machine.compiler) + "},\n  \"hard_cases\": [\n";
  for (std::size_t i = 0; i < cases.size(); ++i) text += "    " + json_row(cases[i]) + (i + 1 < cases.size() ? ",\n" : "\n");
  return text + "  ]\n}\n";
}

}  // namespace psm
