// SPDX-License-Identifier: GPL-3.0-or-later
#include "lesson/condition_reader.h"

namespace psm {
namespace {

constexpr double kLargest = 1e300;

const std::vector<std::string>& warp_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const Warp warp : kCurveWarps) list.emplace_back(csv_name(warp));
    return list;
  }();
  return names;
}

const std::vector<std::string>& column_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const CurveColumn& column : kCurveColumns) list.emplace_back(column.name);
    return list;
  }();
  return names;
}

AnalysisQuantity read_analysis_quantity(const MemberReader& json) {
  AnalysisQuantity quantity;
  quantity.path = json.member("value").text();
  if (json.has("with")) quantity.with = json.member("with").experiment();
  return quantity;
}

CurveQuantity read_curve_quantity(const MemberReader& json) {
  const MemberReader curve = json.member("curve");
  CurveQuantity quantity;
  if (!curve.has_only({"technique", "n", "f", "phi_deg", "theta_deg"})) return quantity;
  const std::string technique = curve.member("technique", true).one_of(warp_names());
  quantity.range.n = curve.member("n", true).number(1e-100, 1e100);
  quantity.range.f = curve.member("f", true).number(1e-100, 1e100);
  quantity.range.phi_deg = curve.member("phi_deg", true).number(1e-6, 90 - 1e-6);
  quantity.theta_deg = curve.member("theta_deg", true).number(0, 180);
  const std::string column = json.member("column", true).one_of(column_names());
  if (!json.fine()) return quantity;
  if (!(quantity.range.f > quantity.range.n)) curve.member("f").fail("not greater than n; allowed: a number greater than n");
  quantity.technique = *warp_from_csv_name(technique);
  for (const CurveColumn& known : kCurveColumns)
    if (known.name == column) quantity.column = known.value;
  return quantity;
}

Scalar read_scalar(const MemberReader& json) {
  switch (json.node().kind) {
    case JsonTree::Kind::boolean:
      return json.node().boolean;
    case JsonTree::Kind::number:
      return json.node().number;
    case JsonTree::Kind::text:
      return json.node().text;
    case JsonTree::Kind::null:
      return {};
    default:
      json.fail("is not allowed; allowed: a text, a number, true, false or null");
      return {};
  }
}

void read_test(const MemberReader& json, Condition& condition) {
  if (json.has("is")) {
    condition.test = Condition::Test::is;
    condition.expected = read_scalar(json.member("is"));
  } else if (json.has("between")) {
    condition.test = Condition::Test::between;
    const auto limits = json.member("between").elements();
    if (limits.size() != 2) return json.member("between").fail("is not allowed; allowed: two numbers, [low, high]");
    condition.lowest = limits[0].number(-kLargest, kLargest);
    condition.highest = limits[1].number(-kLargest, kLargest);
    if (condition.lowest > condition.highest) json.member("between").fail("low is above high; allowed: [low, high]");
  } else {
    const bool above = json.has("above");
    condition.test = above ? Condition::Test::above : Condition::Test::below;
    condition.bound = read_quantity(json.member(above ? "above" : "below"));
  }
}

}  // namespace

Quantity read_quantity(const MemberReader& json) {
  if (json.node().kind == JsonTree::Kind::number) return json.number(-kLargest, kLargest);
  if (json.node().kind != JsonTree::Kind::object || json.has("value") == json.has("curve")) {
    json.fail("no quantity; allowed: a number, {\"value\": PATH} or {\"curve\": {...}, \"column\": NAME}");
    return 0.0;
  }
  // A condition's own members stand beside the quantity's; whoever reads the condition refuses the others.
  if (json.has("value")) return read_analysis_quantity(json);
  return read_curve_quantity(json);
}

Condition read_condition(const MemberReader& json, const std::vector<std::string>& besides) {
  Condition condition;
  condition.line = json.line();
  int tests = 0;
  for (const char* name : {"is", "above", "below", "between"}) tests += json.has(name);
  if (json.fine() && tests != 1) json.fail("needs exactly one test; allowed: is, above, below or between");
  std::vector<std::string> allowed{"is", "above", "below", "between"};
  if (json.has("curve"))
    allowed.insert(allowed.end(), {"curve", "column"});
  else
    allowed.insert(allowed.end(), {"value", "with"});
  allowed.insert(allowed.end(), besides.begin(), besides.end());
  if (!json.has_only(allowed)) return condition;
  condition.quantity = read_quantity(json);
  read_test(json, condition);
  return condition;
}

}  // namespace psm
