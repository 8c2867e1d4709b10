// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// A text is read as a topologic map, once as it stands and once with a checksum that fits: it is refused with a
// FileError, or it is a map that survives being written and read and that takes in another sample.
#include <cstdlib>

#include "base/error.hpp"
#include "base/hash.hpp"
#include "topology/map_text.hpp"

namespace {

using meander::topology::TopologicMap;

void use(const std::string& text) {
  std::optional<TopologicMap> map;
  try {
    map = meander::topology::read_map_text(text, "fuzz.txt");
  } catch (const meander::FileError&) {
    return;
  }
  const std::string again = meander::topology::map_text(*map);
  if (meander::topology::map_text(meander::topology::read_map_text(again, "again.txt")) != again) std::abort();
  meander::Observation seen;
  seen.readings.whisker.resize(static_cast<std::size_t>(map->whiskers()), 1);
  seen.readings.light.resize(static_cast<std::size_t>(map->lights()), 0.5);
  for (int i = 0; i < 3; ++i) map->step(seen);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  use(text);
  const std::string body = text.substr(0, std::min(text.size(), text.rfind("checksum ")));
  use(body + "checksum " + meander::Hash().add(body).hex() + "\n");
  return 0;
}
