// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "app/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>

#include "app/output.hpp"

namespace meander {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kPatience{500};
constexpr std::chrono::milliseconds kBetweenUpdates{100};
constexpr int kBarWidth = 16;

class ProgressLine {
 public:
  void operator()(double fraction, std::string_view label) {
    if (fraction < 0) return hide();
    if (fraction >= 1) return finish();
    const Clock::time_point now = Clock::now();
    const std::string_view name = label.substr(0, label.find('\t'));
    if (fraction < fraction_ || name != name_) start(now, name);
    fraction_ = fraction;
    if (now - started_ < kPatience || now - shown_ < kBetweenUpdates) return;
    shown_ = now;
    show(text(now, label.substr(std::min(label.size(), name.size() + 1))));
  }

 private:
  void start(Clock::time_point now, std::string_view name) {
    started_ = now;
    name_ = name;
  }

  void finish() {
    hide();
    fraction_ = 1;
  }

  void hide() {
    if (width_) show("");
    if (width_) std::fputc('\r', stderr);
    width_ = 0;
  }

  std::string text(Clock::time_point now, std::string_view note) const {
    const int done = static_cast<int>(fraction_ * kBarWidth);
    const double elapsed = std::chrono::duration<double>(now - started_).count();
    const double left = fraction_ > 0 ? elapsed * (1 - fraction_) / fraction_ : 0;
    return fmt::format("{}{}{:#<{}}{:.<{}}  {}{}", name_, name_.empty() ? "" : "  ", "", done, "", kBarWidth - done,
                       note.empty() ? fmt::format("{:.0f} %", 100 * fraction_) : note,
                       left >= 1 ? fmt::format("  {:.0f} s left", left) : "");
  }

  /// Cut where it would wrap around: only the last row of it could be taken back. Blanks cover what the line before was
  /// longer.
  void show(std::string line) {
    winsize size{};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1)
      line.resize(std::min<std::size_t>(line.size(), size.ws_col - 1u));
    fmt::print(stderr, "\r{:<{}}", line, width_);
    width_ = line.empty() ? width_ : std::max(width_, line.size());
  }

  Clock::time_point started_{}, shown_{};
  std::string name_;
  double fraction_ = 1;
  std::size_t width_ = 0;
};

}  // namespace

std::function<void(double, std::string_view)> progress_line() {
  if (!is_able_terminal(STDERR_FILENO)) return {};
  // Copies of the function are about the same line.
  return
      [line = std::make_shared<ProgressLine>()](double fraction, std::string_view label) { (*line)(fraction, label); };
}

}  // namespace meander
