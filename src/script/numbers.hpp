// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "script/kit_object.hpp"

namespace meander::script {

/// A view of numbers that lie somewhere in native memory, evenly spaced. Keeps their owner alive; copies nothing.
class Numbers {
 public:
  enum class Element { real64, real32, byte };

  Numbers() = default;
  Numbers(std::shared_ptr<const void> owner, const double* first, std::size_t count, std::ptrdiff_t stride_bytes = 8)
      : owner_(std::move(owner)), first_(first), count_(count), stride_(stride_bytes), element_(Element::real64) {}
  Numbers(std::shared_ptr<const void> owner, const float* first, std::size_t count, std::ptrdiff_t stride_bytes = 4)
      : owner_(std::move(owner)), first_(first), count_(count), stride_(stride_bytes), element_(Element::real32) {}
  Numbers(std::shared_ptr<const void> owner, const std::uint8_t* first, std::size_t count,
          std::ptrdiff_t stride_bytes = 1)
      : owner_(std::move(owner)), first_(first), count_(count), stride_(stride_bytes), element_(Element::byte) {}

  std::size_t size() const { return count_; }
  /// i < size()
  double operator[](std::size_t i) const;
  /// Elements first .. last of every `step`-th, 0 first, last included.
  Numbers slice(std::size_t first, std::size_t count, std::size_t step) const;

 private:
  std::shared_ptr<const void> owner_;
  const void* first_ = nullptr;
  std::size_t count_ = 0;
  std::ptrdiff_t stride_ = 8;
  Element element_ = Element::real64;
};

/// A view of a vector that lives inside `owner`.
template <class T>
Numbers numbers_of(std::shared_ptr<const void> owner, const std::vector<T>& values) {
  return Numbers(std::move(owner), values.data(), values.size());
}

/// A table of numbers, row by row, shared by its views.
struct Matrix {
  std::shared_ptr<const std::vector<float>> cells;
  std::size_t rows = 0;
  std::size_t columns = 0;
};
inline std::size_t native_size(const Matrix& matrix) { return sizeof(Matrix) + matrix.cells->size() * sizeof(float); }

template <>
struct ObjectName<Numbers> {
  static constexpr const char* value = "numbers";
};
template <>
struct ObjectName<Matrix> {
  static constexpr const char* value = "matrix";
};

}  // namespace meander::script
