// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Any bytes as a graph of indicators and as an explorer: read, or refused with a FileError of one line. What is read
// survives writing and reading.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "indicator/indicator_text.hpp"

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

template <class Read>
void check(const std::string& text, Read read) {
  std::string written;
  try {
    written = to_text(read(text, "fuzz.txt"));
  } catch (const meander::FileError& error) {
    const std::string message = error.what();
    require(message.starts_with("fuzz.txt:"));
    require(message.find('\n') == std::string::npos);
    return;
  }
  require(to_text(read(written, "written.txt")) == written);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  check(text, meander::graph_from_text);
  check(text, meander::explorer_from_text);
  return 0;
}
