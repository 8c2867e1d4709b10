// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/still.hpp"

#include <algorithm>

#include "render/kitty.hpp"
#include "render/raster.hpp"
#include "render/sixel.hpp"

namespace meander {
namespace {

/// Sharp enough, and no more bytes than a slow line bears.
PictureSize size_in(const StillRoom& room) {
  return {std::clamp(room.width, 1, 1200), std::clamp(room.height, 1, 1200)};
}

std::string characters(const DrawList& list, const TerminalSize& size, TerminalMode mode) {
  const std::string picture = text(terminal_frame(list, size, mode));
  if (mode != TerminalMode::ascii) return picture;
  const std::string signs = legend(list);
  return signs.empty() ? picture : picture + signs + "\n";
}

}  // namespace

std::string still_picture(const DrawList& list, const StillRoom& room, StillMode still, TerminalMode mode) {
  switch (still) {
    case StillMode::kitty:
      return kitty_picture(png_bytes(raster(list, size_in(room)), "picture"));
    case StillMode::sixel:
      return sixel_picture(raster(list, size_in(room)));
    case StillMode::characters:
      return characters(list, room.characters, mode);
    case StillMode::none:
      return {};
  }
  return {};
}

}  // namespace meander
