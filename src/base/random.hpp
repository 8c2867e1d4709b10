// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <boost/random/mersenne_twister.hpp>
#include <cstdint>
#include <string_view>

#include "base/hash.hpp"

namespace meander {

/// One named, independent stream of random numbers. Streams of the same master seed but different names are
/// independent: an extra draw in one never shifts another. Same seed and name, same numbers, on every machine.
class Stream {
 public:
  Stream(std::uint64_t seed, std::string_view name);

  double uniform();                         ///< [0, 1)
  double uniform(double low, double high);  ///< [low, high)
  double normal();                          ///< mean 0, standard deviation 1
  double normal(double mean, double sigma) { return mean + sigma * normal(); }
  bool chance(double probability) { return uniform() < probability; }  ///< always draws once
  int below(int count);                                                ///< 0 .. count - 1; count >= 1
  std::uint64_t word();                                                ///< 64 random bits

  /// Adds the position in the stream to a state hash.
  void add_to(Hash& hash) const { hash.add(seed_).add(draws_); }

 private:
  std::uint64_t seed_;
  std::uint64_t draws_ = 0;
  boost::random::mt19937_64 engine_;
};

/// Seed of the `index`-th trial of a study: independent of order, shard and thread.
std::uint64_t trial_seed(std::uint64_t study_seed, std::uint64_t index);

}  // namespace meander
