// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/study_row.h"

#include <cmath>
#include <locale>
#include <sstream>

#include "scene/experiment.h"
#include "scene/json_node.h"

namespace psm {
namespace {

using Row = StudyRow;

StudyColumn machine(const char* name, std::string Row::*member, const char* help) { return {name, member, help, true, true}; }
StudyColumn measured_time(const char* name, double Row::*member, const char* help) { return {name, member, help, false, false}; }

std::vector<StudyColumn> make_columns() {
  return {{"version", &Row::version, "psmlab's version"},
          {"study", &Row::study, "fingerprint of all runs of the study and their experiments"},
          {"run", &Row::run, "number of the run in the study"},
          {"scene", &Row::scene, "scene"},
          {"technique", &Row::technique, "technique, as asked for"},
          {"resolution", &Row::resolution, "texels along a side of the map"},
          {"theta_deg", &Row::theta_deg, "angle between the view direction and the direction to the light, degrees"},
          {"width", &Row::width, "width of the image, pixels"},
          {"height", &Row::height, "height of the image, pixels"},
          {"technique_used", &Row::technique_used, "technique that was used in the end"},
          {"notes", &Row::notes, "codes of what the analysis had to say"},
          {"camera_far", &Row::camera_far, "the camera's far distance, scene units"},
          {"light_radius", &Row::light_radius, "radius of an area light, 0: none"},
          {"depth_bias", &Row::depth_bias, "texels"},
          {"slope_bias", &Row::slope_bias, "part of depth_bias that grows with the slope"},
          {"normal_bias", &Row::normal_bias, "texels"},
          {"cull", &Row::cull, "faces of casters that are left out of the map"},
          {"filter", &Row::filter, "how comparisons are averaged"},
          {"filter_size", &Row::filter_size, "side of the kernel, texels"},
          {"near", &Row::near, "n: depth of the nearest receiver, scene units"},
          {"far", &Row::far, "f: depth of the farthest receiver, scene units"},
          {"phi_deg", &Row::phi_deg, "half the opening angle in the plane of view and light, degrees"},
          {"rho", &Row::rho, "warp strength, 1 for the uniform map"},
          {"texels", &Row::texels, "texels of all maps together"},
          {"compared", &Row::compared, "pixels that the truth calls dark or lit"},
          {"error_fraction", &Row::error_fraction, "wrong pixels over compared pixels"},
          {"wrongly_lit", &Row::wrongly_lit, "pixels"},
          {"wrongly_dark", &Row::wrongly_dark, "pixels"},
          {"outside", &Row::outside, "wrong pixels outside the map"},
          {"by_resolution", &Row::by_resolution, "wrong pixels within m of a true edge"},
          {"acne", &Row::acne, "pixels dark in the map only"},
          {"leak", &Row::leak, "pixels lit in the map only"},
          {"lit_difference", &Row::lit_difference, "mean absolute difference of the lit fraction from the truth"},
          {"m_mean", &Row::m_mean, "mean texel size m, pixels"},
          {"m_p50", &Row::m_p50, "median of m, pixels"},
          {"m_p95", &Row::m_p95, "95th percentile of m, pixels"},
          {"m_max", &Row::m_max, "largest m, pixels"},
          {"undersampled", &Row::undersampled, "fraction of pixels with m > 1"},
          {"model_F", &Row::model_F, "largest F on the central line, closed form"},
          {"model_E", &Row::model_E, "largest E on the central line, closed form"},
          {"line_E", &Row::line_E, "largest E on the central line, measured in the map"},
          {"equal_error_resolution", &Row::equal_error_resolution, "side of the uniform map with no larger error, texels"},
          measured_time("analysis_us", &Row::analysis_us, "the whole analysis"),
          measured_time("bodies_us", &Row::bodies_us, "of that, R, H and H_R, timed beside it"),
          measured_time("map_us", &Row::map_us, "shadow map, wall clock until drawn"),
          measured_time("map_gpu_us", &Row::map_gpu_us, "shadow map, timer query"),
          measured_time("eye_us", &Row::eye_us, "eye's image, wall clock until drawn"),
          measured_time("eye_gpu_us", &Row::eye_gpu_us, "eye's image, timer query"),
          measured_time("timing_runs", &Row::timing_runs, "runs that the medians are of; the eye's of up to 3"),
          measured_time("timing_spread", &Row::timing_spread, "quartile distance over median of analysis and map together"),
          machine("cpu", &Row::cpu, "processor"),
          machine("compiler", &Row::compiler, "compiler"),
          machine("opengl", &Row::opengl, "OpenGL renderer and version"),
          machine("tracer", &Row::tracer, "ray tracer of the truth")};
}

/// One line, quoted where CSV needs it.
std::string csv_text(std::string text) {
  bool plain = true;
  std::string quoted;
  for (char c : text) {
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    if (c == ',' || c == '"') plain = false;
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return plain ? quoted : '"' + quoted + '"';
}

std::string csv_value(const StudyRow& row, const StudyColumn& column) {
  if (const auto text = std::get_if<std::string StudyRow::*>(&column.member)) return csv_text(row.**text);
  const double number = row.*std::get<double StudyRow::*>(column.member);
  return std::isnan(number) ? "" : number_text(number);
}

/// Nothing where a quote is left open.
std::optional<std::vector<std::string>> csv_parts(const std::string& line) {
  std::vector<std::string> parts(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
      parts.back() += line[i++];
    else if (line[i] == '"')
      quoted = !quoted;
    else if (line[i] == ',' && !quoted)
      parts.emplace_back();
    else
      parts.back() += line[i];
  }
  if (quoted) return std::nullopt;
  return parts;
}

bool read_number(const std::string& text, double& number) {
  if (text.empty()) return number = kNone, true;
  if (text == "inf" || text == "-inf") return number = std::copysign(INFINITY, text[0] == '-' ? -1.0 : 1.0), true;
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  return bool(stream >> number) && stream.peek() == std::istringstream::traits_type::eof();
}

JsonNode json_value(const StudyRow& row, const StudyColumn& column) {
  if (const auto text = std::get_if<std::string StudyRow::*>(&column.member)) return row.**text;
  const double number = row.*std::get<double StudyRow::*>(column.member);
  return std::isnan(number) ? JsonNode() : JsonNode(number);
}

JsonNode json_object(const StudyRow& row, bool of_machine) {
  JsonNode object = JsonNode::object();
  for (const StudyColumn& column : study_columns())
    if (column.of_machine == of_machine) object[column.name] = json_value(row, column);
  return object;
}

}  // namespace

const std::vector<StudyColumn>& study_columns() {
  static const std::vector<StudyColumn> columns = make_columns();
  return columns;
}

std::string csv_header() {
  std::string line;
  for (const StudyColumn& column : study_columns()) line += (line.empty() ? "" : ",") + column.name;
  return line + "\n";
}

std::string csv_line(const StudyRow& row) {
  std::string line;
  for (const StudyColumn& column : study_columns()) line += (&column == &study_columns()[0] ? "" : ",") + csv_value(row, column);
  return line + "\n";
}

std::optional<StudyRow> row_from_csv(const std::string& line) {
  const auto parts = csv_parts(line);
  const std::vector<StudyColumn>& columns = study_columns();
  if (!parts || parts->size() != columns.size()) return std::nullopt;
  StudyRow row;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (const auto text = std::get_if<std::string StudyRow::*>(&columns[i].member))
      row.** text = (*parts)[i];
    else if (!read_number((*parts)[i], row.*std::get<double StudyRow::*>(columns[i].member)))
      return std::nullopt;
  }
  return row;
}

std::string rows_to_json(const std::vector<StudyRow>& rows) {
  JsonNode root = JsonNode::object();
  root["psmlab"] = JsonNode::integer(1);
  root["machine"] = rows.empty() ? JsonNode() : json_object(rows.front(), true);
  JsonNode list = JsonNode::array();
  for (const StudyRow& row : rows) list.push_back(json_object(row, false));
  root["rows"] = std::move(list);
  return root.to_text() + "\n";
}

}  // namespace psm
