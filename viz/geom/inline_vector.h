// SPDX-License-Identifier: GPL-3.0-or-later
// A vector whose first N elements need no heap: the bodies here are small, and allocation would cost as much as the geometry.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>

namespace psm {

template <class T, std::size_t N>
class InlineVector {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  InlineVector() = default;
  InlineVector(std::size_t count, const T& value) { resize(count, value); }
  InlineVector(const InlineVector&) = delete;
  InlineVector& operator=(const InlineVector&) = delete;

  T* begin() { return data_; }
  T* end() { return data_ + size_; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }
  const T* data() const { return data_; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  T& back() { return data_[size_ - 1]; }

  void push_back(const T& value) {
    if (size_ == capacity_) grow(2 * capacity_);
    data_[size_++] = value;
  }
  /// One more element, not initialised.
  void append() {
    if (size_ == capacity_) grow(2 * capacity_);
    ++size_;
  }
  void pop_back() { --size_; }
  void clear() { size_ = 0; }
  void resize(std::size_t count, const T& value) {
    if (count > capacity_) grow(count);
    if (count > size_) std::fill(data_ + size_, data_ + count, value);
    size_ = count;
  }

 private:
  void grow(std::size_t capacity) {
    std::unique_ptr<T[]> larger(new T[capacity]);
    std::copy(data_, data_ + size_, larger.get());
    heap_ = std::move(larger);
    data_ = heap_.get();
    capacity_ = capacity;
  }

  struct Storage {
    alignas(T) std::byte bytes[N * sizeof(T)];
  };
  Storage storage_;
  std::unique_ptr<T[]> heap_;
  T* data_ = reinterpret_cast<T*>(storage_.bytes);
  std::size_t size_ = 0, capacity_ = N;
};

}  // namespace psm
