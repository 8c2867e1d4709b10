// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/numbers.hpp"

namespace meander::script {

double Numbers::operator[](std::size_t i) const {
  const auto* at = static_cast<const char*>(first_) + static_cast<std::ptrdiff_t>(i) * stride_;
  switch (element_) {
    case Element::real64:
      return *reinterpret_cast<const double*>(at);
    case Element::real32:
      return *reinterpret_cast<const float*>(at);
    default:
      return *reinterpret_cast<const std::uint8_t*>(at);
  }
}

Numbers Numbers::slice(std::size_t first, std::size_t count, std::size_t step) const {
  Numbers part = *this;
  part.first_ = static_cast<const char*>(first_) + static_cast<std::ptrdiff_t>(first) * stride_;
  part.count_ = count;
  part.stride_ = stride_ * static_cast<std::ptrdiff_t>(step);
  return part;
}

}  // namespace meander::script
