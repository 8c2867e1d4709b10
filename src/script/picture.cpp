// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/picture.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>

#include "render/draw_world.hpp"
#include "render/picture_file.hpp"
#include "render/terminal.hpp"

namespace meander::script {
namespace {

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

TerminalSize terminal_size() {
  winsize size{};
  if (isatty(STDOUT_FILENO) && ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 2)
    return {std::min<int>(size.ws_col, 1000), std::min<int>(size.ws_row - 2, 1000)};  // room for the prompt
  return {};
}

}  // namespace

DrawList picture_of(const World& world) { return draw_world(world); }

std::string terminal_picture(const DrawList& list, const Call& call) {
  const TerminalMode mode = terminal_mode({.is_terminal = session(call.L).terminal,
                                           .term = environment("TERM"),
                                           .colorterm = environment("COLORTERM"),
                                           .no_color = environment("NO_COLOR"),
                                           .force_color = environment("CLICOLOR_FORCE"),
                                           .graphics = environment("MEANDER_GRAPHICS")});
  const std::string picture = text(terminal_frame(list, terminal_size(), mode));
  return mode == TerminalMode::ascii ? picture + legend(list) + "\n" : picture;
}

void save_drawing(const std::string& path, const DrawList& list, const char* suffixes) {
  if (!path.ends_with(".svg") && !path.ends_with(".png")) fail("{}: unknown suffix, {} expected", path, suffixes);
  save_picture(path, list);
}

}  // namespace meander::script
