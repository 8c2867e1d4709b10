// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/random.hpp"

#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_int_distribution.hpp>

namespace meander {

Stream::Stream(std::uint64_t seed, std::string_view name) : seed_(Hash().add(seed).add(name).value()), engine_(seed_) {}

std::uint64_t Stream::word() {
  ++draws_;
  return engine_();
}

double Stream::uniform() { return static_cast<double>(word() >> 11) * 0x1.0p-53; }

double Stream::uniform(double low, double high) { return low + (high - low) * uniform(); }

double Stream::normal() {
  ++draws_;
  return boost::random::normal_distribution<double>()(engine_);
}

int Stream::below(int count) {
  ++draws_;
  return boost::random::uniform_int_distribution<int>(0, count - 1)(engine_);
}

std::uint64_t trial_seed(std::uint64_t study_seed, std::uint64_t index) {
  return Hash().add(study_seed).add("trial").add(index).value();
}

}  // namespace meander
