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

TerminalMode terminal_mode(const TerminalEnvironment& e) {
  if (e.graphics == "half") return colors_of(e);
  if (!e.graphics.empty()) {
    if (const auto mode = enum_from<TerminalMode>(e.graphics)) return *mode;
    std::vector<std::string> known = enum_names<TerminalMode>();
    known.emplace_back("half");
    fail("MEANDER_GRAPHICS: one of {} expected, got '{}'{}", listing(known), e.graphics,
         did_you_mean(e.graphics, known));
  }
  if (!e.no_color.empty()) return TerminalMode::ascii;
  if (!e.force_color.empty() && e.force_color != "0") return colors_of(e);
  if (!e.is_terminal || e.term.empty() || e.term == "dumb") return TerminalMode::ascii;
  return colors_of(e);
}

}  // namespace meander
