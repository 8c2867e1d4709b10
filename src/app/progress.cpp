// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "app/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace meander {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kPatience{500};
constexpr std::chrono::milliseconds kBetweenUpdates{100};
constexpr int kBarWidth = 24;

class ProgressLine {
 public:
  void operator()(double fraction, std::string_view label) {
    if (fraction >= 1) return finish();
    const Clock::time_point now = Clock::now();
    if (fraction < fraction_ || label != label_) start(now, label);
    fraction_ = fraction;
    if (now - started_ < kPatience || now - shown_ < kBetweenUpdates) return;
    shown_ = now;
    show(text(now));
  }

 private:
  void start(Clock::time_point now, std::string_view label) {
    started_ = now;
    label_ = label;
  }

  void finish() {
    if (width_) show("");
    if (width_) std::fputc('\r', stderr);
    width_ = 0;
    fraction_ = 1;
  }

  std::string text(Clock::time_point now) const {
    const int done = static_cast<int>(fraction_ * kBarWidth);
    const double elapsed = std::chrono::duration<double>(now - started_).count();
    const double left = fraction_ > 0 ? elapsed * (1 - fraction_) / fraction_ : 0;
    return fmt::format("{}{}{:#<{}}{:.<{}}  {:.0f} %{}", label_, label_.empty() ? "" : "  ", "", done, "",
                       kBarWidth - done, 100 * fraction_, left >= 1 ? fmt::format("  {:.0f} s left", left) : "");
  }

  /// Blanks cover what the line before was longer.
  void show(const std::string& line) {
    fmt::print(stderr, "\r{:<{}}", line, width_);
    width_ = line.empty() ? width_ : std::max(width_, line.size());
  }

  Clock::time_point started_{}, shown_{};
  std::string label_;
  double fraction_ = 1;
  std::size_t width_ = 0;
};

}  // namespace

std::function<void(double, std::string_view)> progress_line() {
  const char* term = std::getenv("TERM");
  if (!isatty(STDERR_FILENO) || !term || std::string_view(term) == "dumb") return {};
  return ProgressLine();
}

}  // namespace meander
