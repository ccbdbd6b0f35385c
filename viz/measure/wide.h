// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that stand in for exact ones: floating point of 100 or 200 decimal digits, which the templates of viz/math take as
// they take doubles, and rationals, which do not round at all. They share names with <cmath>, so that one formula serves all.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <type_traits>

namespace psm {

/// `Digits` decimal digits, and exponents of 32 bits. Trivial to copy, as GLM's vectors want it.
template <int Digits>
class Wide {
 public:
  static constexpr int kBits = Digits * 1000 / 301 + 2;

  Wide() = default;
  template <class A>
  requires std::is_arithmetic_v<A> Wide(A x) : Wide(from(static_cast<long double>(x))) {}

  /// Rounded once, to the nearest double.
  explicit operator double() const;

  Wide operator-() const { return of(Operation::negate, *this); }
  Wide& operator+=(const Wide& b) { return *this = of(Operation::add, *this, b); }
  Wide& operator-=(const Wide& b) { return *this = of(Operation::subtract, *this, b); }
  Wide& operator*=(const Wide& b) { return *this = of(Operation::multiply, *this, b); }
  Wide& operator/=(const Wide& b) { return *this = of(Operation::divide, *this, b); }

  friend Wide operator+(Wide a, const Wide& b) { return a += b; }
  friend Wide operator-(Wide a, const Wide& b) { return a -= b; }
  friend Wide operator*(Wide a, const Wide& b) { return a *= b; }
  friend Wide operator/(Wide a, const Wide& b) { return a /= b; }
  friend bool operator==(const Wide& a, const Wide& b) { return order(a, b) == 0; }
  friend bool operator!=(const Wide& a, const Wide& b) { return order(a, b) != 0; }
  friend bool operator<(const Wide& a, const Wide& b) { return order(a, b) == -1; }
  friend bool operator>(const Wide& a, const Wide& b) { return order(a, b) == 1; }
  friend bool operator<=(const Wide& a, const Wide& b) { return a < b || a == b; }
  friend bool operator>=(const Wide& a, const Wide& b) { return a > b || a == b; }

  friend Wide abs(const Wide& x) { return x < Wide(0) ? -x : x; }
  friend Wide sqrt(const Wide& x) { return of(Operation::root, x); }
  friend Wide sin(const Wide& x) { return of(Operation::sine, x); }
  friend Wide cos(const Wide& x) { return of(Operation::cosine, x); }
  friend Wide tan(const Wide& x) { return of(Operation::tangent, x); }
  friend Wide atan(const Wide& x) { return of(Operation::arctangent, x); }
  friend Wide acos(const Wide& x) { return of(Operation::arccosine, x); }
  friend Wide atan2(const Wide& y, const Wide& x) { return of(Operation::angle, y, x); }
  friend Wide hypot(const Wide& a, const Wide& b) { return sqrt(a * a + b * b); }
  friend Wide fmod(const Wide& a, const Wide& b) { return of(Operation::remainder, a, b); }
  friend bool isnan(const Wide& x) { return order(x, x) == kUnordered; }
  friend bool isinf(const Wide& x) { return abs(x) == std::numeric_limits<Wide>::infinity(); }
  friend bool isfinite(const Wide& x) { return !isnan(x) && !isinf(x); }

 private:
  enum class Operation {
    add,
    subtract,
    multiply,
    divide,
    negate,
    root,
    sine,
    cosine,
    tangent,
    arctangent,
    arccosine,
    angle,
    remainder
  };
  static constexpr int kUnordered = 2;

  static Wide from(long double x);
  static Wide of(Operation, const Wide& a, const Wide& b);
  static Wide of(Operation operation, const Wide& a) { return of(operation, a, a); }
  static int order(const Wide& a, const Wide& b);  // -1, 0, 1, or kUnordered

  struct Library;  // the conversions to and from what calculates
  std::array<std::uint64_t, (kBits + 63) / 64 + 1> mantissa_;
  std::int32_t exponent_;
  std::uint32_t limbs_;
  bool negative_;
};

/// A fraction of integers of any size.
class Rational {
 public:
  Rational(double exact = 0);
  explicit operator double() const;  // rounded once
  friend Rational operator+(const Rational& a, const Rational& b) { return of('+', a, b); }
  friend Rational operator-(const Rational& a, const Rational& b) { return of('-', a, b); }
  friend Rational operator*(const Rational& a, const Rational& b) { return of('*', a, b); }
  friend Rational operator/(const Rational& a, const Rational& b) { return of('/', a, b); }

 private:
  struct Fraction;
  explicit Rational(std::shared_ptr<const Fraction> fraction) : fraction_(std::move(fraction)) {}
  static Rational of(char operation, const Rational& a, const Rational& b);
  std::shared_ptr<const Fraction> fraction_;
};

}  // namespace psm

template <int Digits>
struct std::numeric_limits<psm::Wide<Digits>> {
  using Number = psm::Wide<Digits>;
  static constexpr bool is_specialized = true, is_signed = true, is_integer = false, is_exact = false;
  static constexpr bool is_iec559 = true;  // how GLM asks whether it is a floating-point number
  static constexpr int digits = Number::kBits;
  static Number epsilon();
  static Number min() { return Number(std::numeric_limits<double>::min()); }
  static Number infinity() { return Number(std::numeric_limits<double>::infinity()); }
  static Number quiet_NaN() { return Number(std::numeric_limits<double>::quiet_NaN()); }
};
template <int Digits>
psm::Wide<Digits> std::numeric_limits<psm::Wide<Digits>>::epsilon() {
  Number power(1);
  for (int i = 1; i < digits; ++i) power /= Number(2);
  return power;
}
