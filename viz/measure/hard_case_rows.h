// SPDX-License-Identifier: GPL-3.0-or-later
// How the rows of hard_cases.h are written down; private to viz/measure.
#pragma once

#include <chrono>
#include <memory>
#include <type_traits>
#include <utility>

#include "measure/hard_cases.h"
#include "measure/map_paths.h"

namespace psm {

using std::acos, std::fmod, std::isfinite;

constexpr double kDegrees = 57.29577951308232;  // in a radian
/// The same, rounded to T.
template <class T>
T degrees() {
  return T(180) / half_turn<T>();
}

/// A strength that is wrong by less than this changes no picture.
constexpr double kUsable = 1e-4;
/// Half a texel moves the edge of a shadow by a texel at most now and then; more is seen.
constexpr double kVisibleTexels = 0.5;

inline CaseAnswer named(std::string reason) {
  CaseAnswer a;
  a.named = std::move(reason);
  return a;
}

/// An input that the compiler must not calculate with: the table says what this machine computes, and how fast.
template <class T>
T given(T x) {
  if constexpr (std::is_arithmetic_v<T>) {
    volatile T opaque = x;
    return opaque;
  } else {
    return x;
  }
}

inline CaseAnswer answer(double value, double texels = std::numeric_limits<double>::quiet_NaN()) {
  CaseAnswer a;
  a.value = value;
  a.texels = texels;
  return a;
}

inline CaseAnswer as_answer(CaseAnswer a) { return a; }
template <class T>
CaseAnswer as_answer(const T& value) {
  return answer(double(value));
}

inline Exact exactly(const Rational& value) { return {double(value), ExactKind::rational}; }
inline Exact exactly(double numerator, double denominator = 1) { return exactly(Rational(numerator) / Rational(denominator)); }

/// f(T{}) in 100 digits and in 200.
template <class F>
Exact in_digits(const F& f) {
  const auto start = std::chrono::steady_clock::now();
  const double value = as_answer(f(Wide<100>{})).value;
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (isnan(value)) return {};
  return {value, ExactKind::digits, value == as_answer(f(Wide<200>{})).value, seconds};
}

/// The table while it is written. Each function takes the number, the case, the quantity, and a function of the arithmetic:
/// f(T{}) gives a number or a CaseAnswer. The returned reference lets a row say more.
class Rows {
 public:
  /// The answer `exact`, by a formula of its own, met by double within `bound`, by float as far as its use needs it.
  template <class F>
  HardCase& equals(int number, const char* name, const char* computed, const Exact& exact, double bound, F f) {
    HardCase& row = add(number, name, computed, f);
    row.demand = Demand::equals;
    row.exact = exact;
    row.double_bound = bound;
    row.float_bound = kUsable;
    return row;
  }

  /// The same where there is no other formula: the one at hand in 100 digits.
  template <class F>
  HardCase& follows(int number, const char* name, const char* computed, double bound, F f) {
    return equals(number, name, computed, in_digits(f), bound, f);
  }

  /// At most `double_bound` in double and `float_bound` in float.
  template <class F>
  HardCase& at_most(int number, const char* name, const char* computed, double double_bound, double float_bound, F f) {
    HardCase& row = follows(number, name, computed, double_bound, f);
    row.demand = Demand::at_most;
    row.float_bound = float_bound;
    return row;
  }

  /// The same of an error or a move on the map: f(T{}, path) goes that way in float, and also by two matrices.
  template <class F>
  HardCase& map_at_most(int number, const char* name, const char* computed, double double_bound, double float_bound, F f) {
    HardCase& row = at_most(number, name, computed, double_bound, float_bound, [f](auto t) { return f(t, FloatPath::composed); });
    row.two_stages = [f] { return as_answer(f(float{}, FloatPath::through_view)); };
    return row;
  }

  /// The same of what is measured against the exact answer, and so is 0 there.
  template <class F>
  HardCase& error_at_most(int number, const char* name, const char* computed, double double_bound, double float_bound, F f) {
    HardCase& row = equals(number, name, computed, exactly(0), double_bound, f);
    row.demand = Demand::at_most;
    row.float_bound = float_bound;
    return row;
  }

  /// Greater than `bound` in both.
  template <class F>
  HardCase& above(int number, const char* name, const char* computed, double bound, F f) {
    HardCase& row = at_most(number, name, computed, bound, bound, f);
    row.demand = Demand::above;
    return row;
  }

  template <class F>
  HardCase& refuses(int number, const char* name, const char* computed, const char* reason, F f) {
    HardCase& row = add(number, name, computed, f);
    row.demand = Demand::refused;
    row.reason = reason;
    return row;
  }

  /// Something is computed, and something is said about it.
  template <class F>
  HardCase& says(int number, const char* name, const char* computed, const char* reason, F f) {
    HardCase& row = refuses(number, name, computed, reason, f);
    row.demand = Demand::said;
    return row;
  }

  /// A map, at every receiver of the scene: the value is u of the last one, the error the largest over all. `build(T{})` gives
  /// the matrix in the arithmetic T.
  template <class Build>
  HardCase& map(int number, const char* name, const char* computed, const MapScene& s, double double_bound, Build build) {
    return map_against(number, name, computed, s, double_bound, exact_map(s, build), build);
  }

  static std::vector<glm::dvec3> rounded(const std::vector<Vec3<Wide<100>>>& points) { return {points.begin(), points.end()}; }

  /// Where every receiver belongs, and u of the last one.
  struct ExactMap {
    std::shared_ptr<const std::vector<glm::dvec3>> points;  // rounded once
    Exact last_u;
  };
  template <class Build>
  static ExactMap exact_map(const MapScene& s, const Build& build) {
    ExactMap exact;
    exact.points = std::make_shared<std::vector<glm::dvec3>>(rounded(map_points<Wide<100>>(build, s, s.receivers)));
    exact.last_u = in_digits([&](auto t) { return map_points<decltype(t)>(build, s, {s.receivers.back()}).back().x; });
    return exact;
  }

  template <class Build>
  HardCase& map_against(int number, const char* name, const char* computed, const MapScene& s, double double_bound,
                        const ExactMap& exact, Build build, FloatPath path = FloatPath::composed) {
    const auto at = [s, build, right = exact.points](auto t, FloatPath by) {
      const auto points = map_points<decltype(t)>(build, s, s.receivers, by);
      return answer(double(points.back().x), texel_distance(points, *right));
    };
    HardCase& row = add(number, name, computed, [at, path](auto t) { return at(t, path); });
    row.two_stages = [at, path] {
      return at(float{}, path == FloatPath::world ? FloatPath::world_through_view : FloatPath::through_view);
    };
    row.demand = Demand::texels;
    row.exact = exact.last_u;
    row.double_bound = double_bound;
    row.float_bound = kVisibleTexels;
    return row;
  }

  /// What a whole analysis says: the program has it in double only, and f() takes no arithmetic.
  template <class F>
  HardCase& analysis(int number, const char* name, const char* computed, Demand demand, F f) {
    HardCase row;
    row.number = number;
    row.name = name;
    row.computed = computed;
    row.demand = demand;
    row.in_double = [f] { return as_answer(f()); };
    return rows_.emplace_back(std::move(row));
  }

  /// Others do this.
  static void naive(HardCase& row) { row.form = Form::naive; }

  std::vector<HardCase> take() { return std::move(rows_); }

 private:
  template <class F>
  HardCase& add(int number, const char* name, const char* computed, F f) {
    HardCase row;
    row.number = number;
    row.name = name;
    row.computed = computed;
    row.in_float = [f] { return as_answer(f(float{})); };
    row.in_double = [f] { return as_answer(f(double{})); };
    return rows_.emplace_back(std::move(row));
  }

  std::vector<HardCase> rows_;
};

void add_warp_cases(Rows& rows);        // 1 to 10, 12, 31, 32, 35, 37: the error model's formulas
void add_projection_cases(Rows& rows);  // 13 to 20: lights and their maps
void add_convention_cases(Rows& rows);  // 11, 33, 34, 36, 38: vectors, bases, angles, depth conventions
void add_scene_cases(Rows& rows);       // 7, 17, 21 to 24, 27 to 30, 37, 39, 42: bodies and whole analyses
void add_caster_cases(Rows& rows);      // 25, 26, 41, 43: casters where the eye does not look, and a moving eye
void add_float_cases(Rows& rows);       // 0 and 40: what narrowing to float costs

}  // namespace psm
