// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// A text is read as the weights of a network, once as it stands and once with a checksum that fits: it is refused with
// a FileError, or it is a network that survives being written and read and that gives finite log-odds.
#include <cmath>
#include <cstdlib>

#include "base/hash.hpp"
#include "mapping/network_file.hpp"

namespace {

void use(const std::string& text) {
  meander::SonarNetwork network;
  try {
    network = meander::network_from_text(text, "fuzz.txt");
  } catch (const meander::FileError&) {
    return;
  }
  const std::string again = meander::network_text(network);
  if (meander::network_text(meander::network_from_text(again, "again.txt")) != again) std::abort();
  if (network.ring.count < 3) return;
  const meander::SonarModel model = meander::network_model(network);
  const std::vector<double> ranges(static_cast<std::size_t>(network.ring.count), 1.0);
  const float range[] = {0.5F, 1.0F, 1.5F}, bearing[] = {-6.2F, 0.0F, 6.2F};
  float log_odds[3];
  model.evaluate({ranges, 6.477}, {range, bearing}, log_odds);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  use(text);
  const std::string body = text.substr(0, std::min(text.size(), text.rfind("checksum ")));
  use(body + "checksum " + meander::Hash().add(body).hex() + "\n");
  return 0;
}
