// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "render/live_picture.hpp"
#include "render/screen.hpp"
#include "script/kit_call.hpp"
#include "script/pace.hpp"
#include "script/terminal_device.hpp"

namespace meander::script {

/// A moving picture on the session's terminal, at the pace of the wall clock. Where there is no terminal, or one that
/// cannot move its cursor, it shows nothing and waits for nothing. However it ends, by an interrupt or an error too,
/// the picture that `last` gives stays in the ordinary screen.
class LiveView {
 public:
  LiveView(const Call& call, double speed, double rate, std::function<std::optional<DrawList>()> last);
  ~LiveView();
  LiveView(const LiveView&) = delete;
  LiveView& operator=(const LiveView&) = delete;

  bool live() const { return screen_.has_value(); }
  /// Leads from one moment to the next, with as many pictures in between as are due; `line` stands below them.
  void pass(LivePicture& picture, const Moment& from, const Moment& to, const std::function<std::string()>& line);
  /// A picture as soon as the next one is due.
  void next(const DrawList& list, const std::string& line);
  /// One picture now.
  void show(const DrawList& list, const std::string& line);
  /// Simulated seconds per second so far.
  double speed() const { return pace_.measured(); }

 private:
  Call call_;
  std::function<std::optional<DrawList>()> last_;
  TerminalMode mode_;
  Pace pace_;
  std::optional<LiveTerminal> terminal_;
  std::optional<Screen> screen_;  ///< after terminal_: it is gone before
};

}  // namespace meander::script
