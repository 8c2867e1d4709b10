// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/terminal_query.hpp"

#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <optional>
#include <utility>

#include "script/terminal_device.hpp"

namespace meander::script {
namespace {

using Clock = std::chrono::steady_clock;

/// A terminal far away answers within this time, or never.
constexpr std::chrono::seconds kLongestWay{10};

std::string typed_ahead;
std::optional<StillMode> known;
std::optional<Clock::time_point> owed_until;  ///< the answer that has not come in time
std::string late;                             ///< its beginning

/// Standard input without echo and without waiting for whole lines, while it lives.
class RawInput {
 public:
  RawInput() {
    tcgetattr(STDIN_FILENO, &before_);
    termios mode = before_;
    mode.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    mode.c_cc[VMIN] = 0;
    mode.c_cc[VTIME] = 0;
    tcsetattr(STDIN_FILENO, TCSANOW, &mode);
  }
  ~RawInput() { tcsetattr(STDIN_FILENO, TCSANOW, &before_); }
  RawInput(const RawInput&) = delete;
  RawInput& operator=(const RawInput&) = delete;

  static bool has_keys(int milliseconds) {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    return poll(&input, 1, milliseconds) > 0;
  }

 private:
  termios before_{};
};

/// Everything that comes until the answer is complete or the time is over.
std::string answer_of_terminal() {
  const auto deadline = Clock::now() + std::chrono::milliseconds(150);
  std::string input;
  while (!read_graphics_answer(input).complete) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0 || !RawInput::has_keys(static_cast<int>(left))) break;
    char bytes[256];
    const ssize_t count = read(STDIN_FILENO, bytes, sizeof bytes);
    if (count <= 0) break;
    input.append(bytes, static_cast<std::size_t>(count));
  }
  return input;
}

/// Puts keys back where they are read next: the prompt takes them itself, a script reads standard input.
void give_back(const std::string& keys, bool at_prompt) {
  if (at_prompt)
    typed_ahead += keys;
  else
    for (auto key = keys.rbegin(); key != keys.rend(); ++key) std::ungetc(static_cast<unsigned char>(*key), stdin);
}

}  // namespace

StillMode asked_still_mode(bool at_prompt) {
  if (known) return *known;
  if (!isatty(STDIN_FILENO) || !holds_terminal()) return StillMode::characters;
  const RawInput raw;
  if (RawInput::has_keys(0)) return StillMode::characters;
  write_at_once(kGraphicsQuery);
  const GraphicsAnswer answer = read_graphics_answer(answer_of_terminal());
  give_back(answer.keys, at_prompt);
  known = answer.still();
  if (!answer.complete) owed_until = Clock::now() + kLongestWay;
  late = answer.rest;
  return *known;
}

bool read_late_answer() {
  if (!owed_until || Clock::now() > *owed_until) return false;
  char bytes[256];
  const ssize_t count = read(STDIN_FILENO, bytes, sizeof bytes);
  if (count <= 0) return false;
  const GraphicsAnswer answer = read_graphics_answer(late.append(bytes, static_cast<std::size_t>(count)));
  typed_ahead += answer.keys;
  late = answer.rest;
  if (!answer.complete) return true;
  known = answer.still();
  owed_until.reset();
  return true;
}

std::string take_typed_ahead() { return std::exchange(typed_ahead, {}); }

}  // namespace meander::script
