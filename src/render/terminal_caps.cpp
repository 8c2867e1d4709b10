// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/terminal_caps.hpp"

#include "base/names.hpp"

namespace meander {
namespace {

TerminalMode colors_of(const TerminalEnvironment& e) {
  const bool announced = e.colorterm == "truecolor" || e.colorterm == "24bit" || e.term.ends_with("-direct");
  return announced ? TerminalMode::truecolor : TerminalMode::color256;
}

}  // namespace

std::vector<std::string> graphics_words() {
  std::vector<std::string> words = enum_names<TerminalMode>();
  for (const char* word : {"half", "sixel", "kitty", "none"}) words.emplace_back(word);
  return words;
}

TerminalMode terminal_mode(const TerminalEnvironment& e) {
  if (e.graphics == "half" || e.graphics == "sixel" || e.graphics == "kitty") return colors_of(e);
  if (e.graphics == "none") return TerminalMode::ascii;
  if (!e.graphics.empty()) {
    if (const auto mode = enum_from<TerminalMode>(e.graphics)) return *mode;
    const std::vector<std::string> known = graphics_words();
    fail("MEANDER_GRAPHICS: one of {} expected, got '{}'{}", listing(known), e.graphics,
         did_you_mean(e.graphics, known));
  }
  if (!e.no_color.empty()) return TerminalMode::ascii;
  if (!e.force_color.empty() && e.force_color != "0") return colors_of(e);
  if (!e.is_terminal || e.term.empty() || e.term == "dumb") return TerminalMode::ascii;
  return colors_of(e);
}

std::optional<StillMode> still_mode(const TerminalEnvironment& e) {
  const bool plain = terminal_mode(e) == TerminalMode::ascii;  // throws for an unknown word
  if (e.graphics == "none") return StillMode::none;
  if (e.graphics == "sixel") return StillMode::sixel;
  if (e.graphics == "kitty") return StillMode::kitty;
  // The console of Linux writes questions that it does not know.
  const bool mute = !e.is_terminal || e.multiplexed || e.term == "linux" || e.term.starts_with("screen") ||
                    e.term.starts_with("tmux");
  if (plain || mute || !e.graphics.empty()) return StillMode::characters;
  return std::nullopt;
}

GraphicsAnswer read_graphics_answer(std::string_view input) {
  GraphicsAnswer answer;
  while (!input.empty()) {
    const bool graphics = input.starts_with("\x1b_G"), attributes = input.starts_with("\x1b[?");
    const std::size_t end = graphics ? input.find("\x1b\\") : attributes ? input.find('c') : 0;
    if (!graphics && !attributes) {
      answer.keys += input.front();
      input.remove_prefix(1);
    } else if (end == std::string_view::npos) {
      answer.rest = input;
      break;
    } else if (graphics) {
      answer.kitty = input.substr(0, end).find(";OK") != std::string_view::npos;
      input.remove_prefix(end + 2);
    } else {
      const std::string listed = ";" + std::string(input.substr(3, end - 3)) + ";";
      answer.sixel = listed.find(";4;") != std::string::npos;
      answer.complete = true;
      input.remove_prefix(end + 1);
    }
  }
  return answer;
}

}  // namespace meander
