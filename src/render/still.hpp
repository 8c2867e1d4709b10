// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "render/terminal.hpp"

namespace meander {

/// Room for a picture that stays in a terminal.
struct StillRoom {
  TerminalSize characters{};
  int width = 800, height = 480;  ///< the same in pixels
};

/// The picture as a terminal takes it, ending in a new line. Nothing for StillMode::none.
std::string still_picture(const DrawList& list, const StillRoom& room, StillMode still, TerminalMode mode);

}  // namespace meander
