// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "study/worker.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <utility>

#include "base/error.hpp"

namespace meander {
namespace {

/// Exit code of a child in which something was thrown that no trial should throw; EX_SOFTWARE of sysexits.h.
constexpr int kEscaped = 70;

/// What goes before the text of a result.
struct Head {
  std::uint64_t ok;
  std::uint64_t size;
};

bool send_all(int socket, const void* data, std::size_t size) {
  const char* at = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t sent = send(socket, at, size, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    at += sent;
    size -= static_cast<std::size_t>(sent);
  }
  return true;
}

TrialResult run(const std::function<std::string(std::size_t)>& trial, std::size_t index) {
  try {
    return {index, true, trial(index)};
  } catch (const std::exception& e) {
    return {index, false, e.what()};
  } catch (const Cancelled&) {
    return {index, false, "cancelled"};
  }
}

void flush_all() {
  std::cout.flush();
  std::cerr.flush();
  std::fflush(nullptr);
}

/// The child's whole life. Ends by _exit: what the parent had registered for its own end must not run twice. Nothing
/// may leave it, errors of any type included: they would go on in a second copy of the parent.
[[noreturn]] void serve(int socket, const std::function<std::string(std::size_t)>& trial, std::size_t index) noexcept {
  // Ctrl-C reaches the whole process group; the parent decides what it means. Without a parent there is nothing to do.
  signal(SIGINT, SIG_IGN);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  try {
    const TrialResult result = run(trial, index);
    flush_all();
    const Head head{result.ok, result.text.size()};
    if (send_all(socket, &head, sizeof head)) send_all(socket, result.text.data(), result.text.size());
    _exit(0);
  } catch (...) {
    _exit(kEscaped);
  }
}

std::string how_it_died(int status) {
  if (WIFSIGNALED(status))
    return fmt::format("the worker process crashed: signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
  return fmt::format("the worker process ended with exit code {}", WEXITSTATUS(status));
}

/// Kills the process, which changes nothing when it is dead already, and returns how it ended.
int end_process(pid_t process) {
  kill(process, SIGKILL);
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

Worker::Worker(const std::function<std::string(std::size_t)>& trial, std::size_t index, std::span<const int> others)
    : trial_(index) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    fail<Error>("cannot start a worker process: {}", std::strerror(errno));
  flush_all();
  process_ = fork();
  if (process_ < 0) {
    const int why = errno;
    close(ends[0]);
    close(ends[1]);
    fail<Error>("cannot start a worker process: {}", std::strerror(why));
  }
  if (process_ == 0) {
    close(ends[0]);
    for (const int other : others) close(other);
    serve(ends[1], trial, index);
  }
  close(ends[1]);
  socket_ = ends[0];
}

Worker::~Worker() {
  if (socket_ >= 0) close(socket_);
  if (process_ <= 0) return;
  end_process(process_);
}

std::optional<TrialResult> Worker::receive() {
  char part[1 << 16];
  const ssize_t got = recv(socket_, part, sizeof part, MSG_DONTWAIT);
  if (got < 0 && (errno == EINTR || errno == EAGAIN)) return std::nullopt;
  if (got <= 0) return TrialResult{trial_, false, how_it_died(end_process(std::exchange(process_, -1)))};
  inbox_.append(part, static_cast<std::size_t>(got));
  Head head;
  if (inbox_.size() < sizeof head) return std::nullopt;
  std::memcpy(&head, inbox_.data(), sizeof head);
  if (inbox_.size() < sizeof head + head.size) return std::nullopt;
  return TrialResult{trial_, head.ok != 0, inbox_.substr(sizeof head)};
}

}  // namespace meander
