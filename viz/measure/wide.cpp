// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/wide.h"

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>

namespace psm {

namespace mp = boost::multiprecision;

template <int Digits>
struct Wide<Digits>::Library {
  using Number = mp::number<mp::cpp_bin_float<Digits>, mp::et_off>;

  static Number number(const Wide& x) {
    Number out;
    auto& b = out.backend();
    b.bits().resize(x.limbs_, x.limbs_);
    std::copy_n(x.mantissa_.data(), x.limbs_, b.bits().limbs());
    b.exponent() = x.exponent_;
    b.sign() = x.negative_;
    return out;
  }

  static Wide wide(const Number& x) {
    const auto& b = x.backend();
    static_assert(sizeof(*b.bits().limbs()) == sizeof(std::uint64_t));
    Wide out;
    out.mantissa_.fill(0);
    out.limbs_ = b.bits().size();
    assert(out.limbs_ <= out.mantissa_.size());
    std::copy_n(b.bits().limbs(), out.limbs_, out.mantissa_.data());
    out.exponent_ = b.exponent();
    out.negative_ = b.sign();
    return out;
  }
};

template <int Digits>
Wide<Digits> Wide<Digits>::from(long double x) {
  return Library::wide(typename Library::Number(x));
}

template <int Digits>
Wide<Digits>::operator double() const {
  return Library::number(*this).template convert_to<double>();
}

template <int Digits>
int Wide<Digits>::order(const Wide& x, const Wide& y) {
  const auto a = Library::number(x), b = Library::number(y);
  return a < b ? -1 : a > b ? 1 : a == b ? 0 : kUnordered;
}

template <int Digits>
Wide<Digits> Wide<Digits>::of(Operation operation, const Wide& x, const Wide& y) {
  using Number = typename Library::Number;
  const Number a = Library::number(x), b = Library::number(y);
  const auto result = [&]() -> Number {
    switch (operation) {
      case Operation::add:
        return a + b;
      case Operation::subtract:
        return a - b;
      case Operation::multiply:
        return a * b;
      case Operation::divide:
        return a / b;
      case Operation::negate:
        return -a;
      case Operation::root:
        return a < 0 ? std::numeric_limits<Number>::quiet_NaN() : mp::sqrt(a);  // the library throws
      case Operation::sine:
        return mp::sin(a);
      case Operation::cosine:
        return mp::cos(a);
      case Operation::tangent:
        return mp::tan(a);
      case Operation::arctangent:
        return mp::atan(a);
      case Operation::arccosine:
        return mp::acos(a);
      case Operation::angle:
        return mp::atan2(a, b);
      case Operation::remainder:
        return mp::fmod(a, b);
    }
    return std::numeric_limits<Number>::quiet_NaN();
  };
  return Library::wide(result());
}

template class Wide<100>;
template class Wide<200>;

struct Rational::Fraction {
  mp::cpp_rational value;
};

Rational::Rational(double exact) : fraction_(std::make_shared<Fraction>(Fraction{mp::cpp_rational(exact)})) {}

Rational::operator double() const { return fraction_->value.convert_to<double>(); }

Rational Rational::of(char operation, const Rational& x, const Rational& y) {
  const mp::cpp_rational &a = x.fraction_->value, &b = y.fraction_->value;
  const mp::cpp_rational value = operation == '+'   ? mp::cpp_rational(a + b)
                                 : operation == '-' ? mp::cpp_rational(a - b)
                                 : operation == '*' ? mp::cpp_rational(a * b)
                                                    : mp::cpp_rational(a / b);
  return Rational(std::make_shared<const Fraction>(Fraction{value}));
}

}  // namespace psm
