// SPDX-License-Identifier: GPL-3.0-or-later
// Bad input is a value, not an exception: one line that says what, where, and what is allowed.
#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace psm {

/// One line for the user: file or flag, place, what is wrong, what is allowed. No trailing newline.
struct InputError {
  std::string text;
};

/// A value, or the reason why there is none.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}
  Result(InputError error) : state_(std::move(error)) {}

  explicit operator bool() const { return std::holds_alternative<T>(state_); }
  T& operator*() {
    assert(*this);
    return std::get<T>(state_);
  }
  const T& operator*() const {
    assert(*this);
    return std::get<T>(state_);
  }
  T* operator->() { return &**this; }
  const T* operator->() const { return &**this; }
  const InputError& error() const {
    assert(!*this);
    return std::get<InputError>(state_);
  }

 private:
  std::variant<T, InputError> state_;
};

}  // namespace psm
