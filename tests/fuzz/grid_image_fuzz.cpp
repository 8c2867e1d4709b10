// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Any bytes are an image or a FileError.
#include "base/error.hpp"
#include "grid/image_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    meander::image_from_bytes({data, size}, "fuzz");
  } catch (const meander::FileError&) {
  }
  return 0;
}
