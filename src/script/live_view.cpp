// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/live_view.hpp"

#include "script/picture.hpp"

namespace meander::script {

LiveView::LiveView(const Call& call, double speed, double rate, std::function<std::optional<DrawList>()> last)
    : call_(call),
      last_(std::move(last)),
      mode_(terminal_mode(terminal_environment(call))),
      pace_(speed, rate, call.work()) {
  const Session& session = script::session(call.L);
  if (!session.terminal || still_mode(terminal_environment(call)) == StillMode::none) return;
  hide_progress(call.L);
  if (session.write) {
    screen_.emplace(session.write);
  } else if (holds_terminal()) {
    terminal_.emplace();
    screen_.emplace(write_at_once);
  }
}

LiveView::~LiveView() {
  screen_.reset();
  terminal_.reset();
  try {
    if (const auto picture = last_()) call_.write(terminal_picture(*picture, call_));
  } catch (const std::exception&) {
    // what it ended by matters more than its last picture
  }
}

void LiveView::pass(LivePicture& picture, const Moment& from, const Moment& to,
                    const std::function<std::string()>& line) {
  if (!live()) return;
  pace_.pass(from.time, to.time,
             [&](double share) { show(picture.at(share < 1 ? between(from, to, share) : to), line()); });
}

void LiveView::next(const DrawList& list, const std::string& line) {
  if (!live()) return;
  pace_.wait_for_frame();
  show(list, line);
}

void LiveView::show(const DrawList& list, const std::string& line) {
  if (!live()) return;
  if (terminal_ && terminal_->resumed()) screen_->forget();
  const TerminalSize window = window_size().value_or(TerminalSize{});
  screen_->show(terminal_frame(list, Screen::room(window), mode_), line, window);
}

}  // namespace meander::script
