// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>
#include <string>
#include <utility>

#include "base/fields.hpp"

namespace meander {

/// How a picture reaches the terminal, from the plainest up.
enum class TerminalMode { ascii, color256, truecolor };
template <>
struct EnumNames<TerminalMode> {
  static constexpr std::pair<TerminalMode, const char*> entries[] = {
      {TerminalMode::ascii, "ascii"}, {TerminalMode::color256, "color256"}, {TerminalMode::truecolor, "truecolor"}};
};

/// What the environment says about the terminal. Empty: not set.
struct TerminalEnvironment {
  bool is_terminal = false;  ///< does the output go to one?
  std::string term;          ///< TERM
  std::string colorterm;     ///< COLORTERM
  std::string no_color;      ///< NO_COLOR, see no-color.org: set and not empty means no colours
  std::string force_color;   ///< CLICOLOR_FORCE: set and not "0" means colours even into a pipe
  std::string graphics;      ///< MEANDER_GRAPHICS: a mode by name, or "half": colours, as many as the terminal has
};

/// The mode to use. MEANDER_GRAPHICS wins over everything, NO_COLOR over CLICOLOR_FORCE. Throws ArgumentError when
/// MEANDER_GRAPHICS is none of the known words.
TerminalMode terminal_mode(const TerminalEnvironment& environment);

}  // namespace meander
