// SPDX-License-Identifier: GPL-3.0-or-later
// How the rows of hard_cases.h are written down; private to viz/measure.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>

#include "measure/hard_cases.h"
#include "measure/map_paths.h"

namespace psm {

constexpr Extended kNotANumber = std::numeric_limits<Extended>::quiet_NaN();
constexpr double kDegrees = 57.29577951308232;  // in a radian

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
  volatile T opaque = x;
  return opaque;
}

inline CaseAnswer answer(Extended value, double texels = std::numeric_limits<double>::quiet_NaN()) {
  CaseAnswer a;
  a.value = value;
  a.texels = texels;
  return a;
}

inline CaseAnswer as_answer(CaseAnswer a) { return a; }
template <class T>
requires std::is_arithmetic_v<T> CaseAnswer as_answer(T value) { return answer(Extended(value)); }

/// The table while it is written. Each function takes the number, the case, the quantity, and a function of the arithmetic:
/// f(T{}) gives a number or a CaseAnswer. The returned reference lets a row say more.
class Rows {
 public:
  /// The closed form `exact`, met by double within `bound`, by float as far as its use needs it.
  template <class F>
  HardCase& equals(int number, const char* name, const char* computed, Extended exact, double bound, F f) {
    HardCase& row = add(number, name, computed, f);
    row.demand = Demand::equals;
    row.exact = exact;
    row.closed_form = true;
    row.double_bound = bound;
    row.float_bound = kUsable;
    return row;
  }

  /// The same where no closed form exists: extended arithmetic gives the exact answer.
  template <class F>
  HardCase& follows(int number, const char* name, const char* computed, double bound, F f) {
    HardCase& row = equals(number, name, computed, as_answer(f(Extended{})).value, bound, f);
    row.closed_form = false;
    return row;
  }

  /// At most `double_bound` in double and `float_bound` in float.
  template <class F>
  HardCase& at_most(int number, const char* name, const char* computed, double double_bound, double float_bound, F f) {
    HardCase& row = follows(number, name, computed, double_bound, f);
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
    const auto exact = std::make_shared<std::vector<Vec3<Extended>>>(map_points<Extended>(build, s, s.receivers));
    return map_against(number, name, computed, s, double_bound, exact, build);
  }

  template <class Build>
  HardCase& map_against(int number, const char* name, const char* computed, const MapScene& s, double double_bound,
                        std::shared_ptr<std::vector<Vec3<Extended>>> exact, Build build, FloatPath path = FloatPath::composed) {
    const auto at = [s, build, exact](auto t, FloatPath by) {
      const auto points = map_points<decltype(t)>(build, s, s.receivers, by);
      return answer(Extended(points.back().x), texel_distance(points, *exact));
    };
    HardCase& row = add(number, name, computed, [at, path](auto t) { return at(t, path); });
    row.two_stages = [at, path] {
      return at(float{}, path == FloatPath::world ? FloatPath::world_through_view : FloatPath::through_view);
    };
    row.demand = Demand::texels;
    row.exact = exact->back().x;
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

  /// Others do this, and it fails.
  static void naive(HardCase& row) { row.form = Form::naive, row.known_to_fail = true; }
  /// Others do this, and here it does not fail.
  static void harmless(HardCase& row) { row.form = Form::naive; }
  static void float_fails(HardCase& row) { row.known_to_fail = true; }

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
