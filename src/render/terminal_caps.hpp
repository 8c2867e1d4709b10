// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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
  std::string graphics;      ///< MEANDER_GRAPHICS: one of graphics_words()
  bool multiplexed = false;  ///< inside tmux or screen, which pass no pictures on
};

/// What MEANDER_GRAPHICS may say: a mode of characters by name; half: colours, as many as the terminal has; a protocol
/// for stills (live pictures are characters then); none: no pictures.
std::vector<std::string> graphics_words();

/// The mode of pictures made of characters. MEANDER_GRAPHICS wins over everything, NO_COLOR over CLICOLOR_FORCE. Throws
/// ArgumentError when MEANDER_GRAPHICS is none of the known words.
TerminalMode terminal_mode(const TerminalEnvironment& environment);

/// How a picture that stays is shown.
enum class StillMode { none, characters, sixel, kitty };

/// How to show stills; nothing where only the terminal itself can tell what it understands.
std::optional<StillMode> still_mode(const TerminalEnvironment& environment);

/// What asks a terminal for the protocols it understands. Every terminal answers the last part of it.
inline constexpr const char* kGraphicsQuery = "\x1b_Gi=31,s=1,v=1,a=q,t=d,f=24;AAAA\x1b\\\x1b[c";

/// What came back: the terminal's answers, and keys that the user pressed meanwhile.
struct GraphicsAnswer {
  bool complete = false;  ///< the last part was answered
  bool kitty = false;
  bool sixel = false;
  std::string keys;
  std::string rest;  ///< the beginning of an answer whose end has not come
  StillMode still() const { return kitty ? StillMode::kitty : sixel ? StillMode::sixel : StillMode::characters; }
};
GraphicsAnswer read_graphics_answer(std::string_view input);

}  // namespace meander
