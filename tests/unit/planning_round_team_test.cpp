// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "planning/round_team.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace meander {
namespace {

TEST(RoundTeam, EveryItemOfEveryRoundIsDoneOnceBeforeTheRoundEnds) {
  for (const int helpers : {0, 1, 3}) {
    RoundTeam team(helpers);
    std::vector<int> done(257, 0);
    for (int round = 1; round <= 2000; ++round) {
      const std::size_t count = static_cast<std::size_t>(round) % done.size();
      team.run(count, 4, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) ++done[i];
      });
      for (std::size_t i = 0; i < count; ++i) done[i] -= 1;
      ASSERT_EQ(std::count(done.begin(), done.end(), 0), 257) << helpers << " helpers, round " << round;
    }
  }
}

TEST(RoundTeam, ATeamWithoutWorkEnds) {
  const RoundTeam team(2);
  SUCCEED();
}

}  // namespace
}  // namespace meander
