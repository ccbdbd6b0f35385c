// SPDX-License-Identifier: GPL-3.0-or-later
#include "lesson/evaluate.h"

#include <cmath>
#include <cstdio>

namespace psm {
namespace {

/// Infinities are texts in JSON.
Scalar scalar_of_text(const std::string& text) {
  if (text == "inf") return HUGE_VAL;
  if (text == "-inf") return -HUGE_VAL;
  return text;
}

std::optional<Scalar> scalar_at(const JsonTree& analysis, const std::string& path) {
  const JsonTree* node = analysis.at(path);
  if (!node) return std::nullopt;
  switch (node->kind) {
    case JsonTree::Kind::null:
      return Scalar{};
    case JsonTree::Kind::boolean:
      return node->boolean;
    case JsonTree::Kind::number:
      return node->number;
    case JsonTree::Kind::text:
      return scalar_of_text(node->text);
    case JsonTree::Kind::array:
      return node->to_text();
    default:
      return std::nullopt;
  }
}

struct Evaluate {
  const LessonState& state;
  const Analyze& analyze;

  Result<Scalar> operator()(double number) const { return Scalar(number); }
  Result<Scalar> operator()(const CurveQuantity& curve) const {
    const double value = curve_row(curve.range, curve.theta_deg, curve.technique).*curve.column;
    return std::isnan(value) ? Scalar{} : Scalar(value);
  }
  Result<Scalar> operator()(const AnalysisQuantity& quantity) const {
    const bool texels = needs_texels(quantity.path) && (quantity.with || !scalar_at(state.analysis, quantity.path));
    if (!quantity.with && !texels) return at(state.analysis, quantity.path);
    if (!quantity.with) return at(state_of(*state.loaded, analyze(*state.loaded, true)).analysis, quantity.path);
    const auto other = with_members(*state.loaded, *quantity.with, "with");
    if (!other) return other.error();
    return at(state_of(*other, analyze(*other, texels)).analysis, quantity.path);
  }
  static Result<Scalar> at(const JsonTree& analysis, const std::string& path) {
    if (auto scalar = scalar_at(analysis, path)) return *scalar;
    return InputError{"\"" + quotable(path) +
                      "\" leads to no value; allowed: a path to a number, a text, true, false or null in what "
                      "psmlab analyze prints"};
  }
};

bool same(const Scalar& a, const Scalar& b) {
  const double *x = std::get_if<double>(&a), *y = std::get_if<double>(&b);
  if (!x || !y) return a == b;
  if (*x == *y || std::isinf(*x) || std::isinf(*y)) return *x == *y;
  return std::abs(*x - *y) <= 1e-9 * std::max(std::abs(*x), std::abs(*y));
}

Scalar with_infinities(const Scalar& scalar) {
  const std::string* text = std::get_if<std::string>(&scalar);
  return text ? scalar_of_text(*text) : scalar;
}

std::string shown(const Scalar& scalar) {
  if (const double* number = std::get_if<double>(&scalar)) return number_text(*number);
  if (const bool* flag = std::get_if<bool>(&scalar)) return *flag ? "true" : "false";
  const std::string* text = std::get_if<std::string>(&scalar);
  return text ? *text : "null";
}

/// A vector stands in brackets; a longer array or an object is none that a line of text could show.
std::string live_text(const JsonTree& node) {
  if (node.kind == JsonTree::Kind::text) return node.text == "inf" ? "\u221e" : node.text == "-inf" ? "\u2212\u221e" : node.text;
  if (node.kind == JsonTree::Kind::boolean) return node.boolean ? "yes" : "no";
  if (node.kind == JsonTree::Kind::number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", node.number);
    return text;
  }
  if (node.kind != JsonTree::Kind::array || node.items.size() > 4) return "-";
  std::string out;
  for (const JsonTree& item : node.items) out += (out.empty() ? "" : ", ") + live_text(item);
  return "(" + out + ")";
}

}  // namespace

bool needs_texels(const std::string& path) { return path.starts_with("error.texels."); }

LessonState state_of(const LoadedExperiment& loaded, const Analysis& analysis) {
  auto tree = parse_json(analysis_to_json(analysis, loaded.scene));
  assert(tree);
  return {&loaded, std::move(*tree)};
}

Result<LoadedExperiment> with_members(const LoadedExperiment& loaded, const ExperimentMembers& members,
                                      const std::string& place) {
  LoadedExperiment out = loaded;
  const std::string& source = members.values.scene.source;
  if (members.has("scene.source") && source != loaded.experiment.scene.source) {
    auto scene = load_scene(source, loaded.base);
    if (!scene) return InputError{place + ": " + scene.error().text};
    out.scene = std::move(*scene);
    if (out.scene.camera) out.experiment.camera = *out.scene.camera;
    if (out.scene.light) out.experiment.light = *out.scene.light;
  }
  members.copy_to(out.experiment);
  if (auto error = check_experiment(out.experiment)) return InputError{place + ": " + error->text};
  return out;
}

Result<Scalar> evaluate(const Quantity& quantity, const LessonState& state, const Analyze& analyze) {
  return std::visit(Evaluate{state, analyze}, quantity);
}

Result<bool> holds(const Condition& condition, const LessonState& state, const Analyze& analyze) {
  const auto value = evaluate(condition.quantity, state, analyze);
  if (!value) return value.error();
  if (condition.test == Condition::Test::is) return same(*value, with_infinities(condition.expected));
  const double* number = std::get_if<double>(&*value);
  if (condition.test == Condition::Test::between) return number && *number >= condition.lowest && *number <= condition.highest;
  const auto bound = evaluate(condition.bound, state, analyze);
  if (!bound) return bound.error();
  const double* limit = std::get_if<double>(&*bound);
  if (!number || !limit) return false;
  return condition.test == Condition::Test::above ? *number > *limit : *number < *limit;
}

std::string why_not(const Condition& condition, const LessonState& state, const Analyze& analyze) {
  const auto value = evaluate(condition.quantity, state, analyze);
  if (!value) return value.error().text;
  const std::string left = shown(*value) + " is not ";
  if (condition.test == Condition::Test::is) return left + shown(condition.expected);
  if (condition.test == Condition::Test::between)
    return left + "between " + number_text(condition.lowest) + " and " + number_text(condition.highest);
  const auto bound = evaluate(condition.bound, state, analyze);
  if (!bound) return bound.error().text;
  return left + (condition.test == Condition::Test::above ? "above " : "below ") + shown(*bound);
}

std::string live_text(const JsonTree& analysis, const std::string& path) {
  const JsonTree* node = analysis.at(path);
  return node ? live_text(*node) : "-";
}

}  // namespace psm
