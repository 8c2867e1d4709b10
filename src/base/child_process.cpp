// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/child_process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <utility>

#include "base/error.hpp"

namespace meander {
namespace {

/// Exit code of a child in which something was thrown that no work should throw; EX_SOFTWARE of sysexits.h.
constexpr int kEscaped = 70;

/// What goes before the text of a result.
struct Head {
  std::uint64_t ok;
  std::uint64_t size;
};

/// Two joined ends, closed unless they are released.
class Ends {
 public:
  explicit Ends(bool wanted) {
    if (wanted && socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends_.data()) != 0)
      fail<Error>("cannot start a worker process: {}", std::strerror(errno));
  }
  ~Ends() {
    for (const int end : ends_)
      if (end >= 0) close(end);
  }
  Ends(const Ends&) = delete;
  Ends& operator=(const Ends&) = delete;
  int at(std::size_t i) const { return ends_[i]; }
  int release(std::size_t i) { return std::exchange(ends_[i], -1); }

 private:
  std::array<int, 2> ends_{-1, -1};
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

ChildResult run(const std::function<std::string()>& work) {
  try {
    return {true, false, work()};
  } catch (const std::exception& e) {
    return {false, false, e.what()};
  } catch (const Cancelled&) {
    return {false, false, "cancelled"};
  }
}

void flush_all() {
  std::cout.flush();
  std::cerr.flush();
  std::fflush(nullptr);
}

/// Lines on stdout and stderr keep their order, also with those of programs that the child starts.
void redirect(int output) {
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (nothing < 0 || dup2(nothing, STDIN_FILENO) < 0 || dup2(output, STDOUT_FILENO) < 0 ||
      dup2(output, STDERR_FILENO) < 0)
    _exit(kEscaped);
  static char buffer[BUFSIZ];  // with one of its own, glibc forgets how the parent's was filled
  std::setvbuf(stdout, buffer, _IOLBF, sizeof buffer);
}

void settle(int output) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (output < 0) {
    signal(SIGINT, SIG_IGN);  // Ctrl-C reaches the whole process group; the parent decides what it means
    return;
  }
  setpgid(0, 0);
  signal(SIGINT, SIG_DFL);
  redirect(output);
}

std::string how_it_died(int status) {
  if (WIFSIGNALED(status))
    return fmt::format("the worker process crashed: signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
  return fmt::format("the worker process ended with exit code {}", WEXITSTATUS(status));
}

/// Appends what can be read without waiting. False when nothing can come any more.
bool read_some(int socket, std::string& inbox) {
  char part[1 << 16];
  const ssize_t got = recv(socket, part, sizeof part, MSG_DONTWAIT);
  if (got > 0) inbox.append(part, static_cast<std::size_t>(got));
  return got > 0 || (got < 0 && (errno == EINTR || errno == EAGAIN));
}

}  // namespace

ChildProcess::ChildProcess(const std::function<std::string()>& work, std::span<const int> others,
                           Surroundings surroundings)
    : surroundings_(surroundings) {
  Ends results(true), outputs(surroundings == Surroundings::own);
  flush_all();
  process_ = fork();
  if (process_ < 0) fail<Error>("cannot start a worker process: {}", std::strerror(errno));
  if (process_ == 0) {
    close(results.at(0));
    if (outputs.at(0) >= 0) close(outputs.at(0));
    live(results.at(1), outputs.at(1), work, others);
  }
  if (surroundings_ == Surroundings::own) setpgid(process_, process_);  // whoever comes first, parent or child
  socket_ = results.release(0);
  output_ = outputs.release(0);
}

ChildProcess::~ChildProcess() {
  if (socket_ >= 0) close(socket_);
  if (output_ >= 0) close(output_);
  if (process_ > 0) end();
}

/// The child's whole life. Ends by _exit: what the parent had registered for its own end must not run twice. Nothing
/// may leave it, errors of any type included: they would go on in a second copy of the parent.
void ChildProcess::live(int socket, int output, const std::function<std::string()>& work,
                        std::span<const int> others) noexcept {
  for (const int other : others) close(other);
  settle(output);
  try {
    const ChildResult result = run(work);
    flush_all();
    const Head head{result.ok, result.text.size()};
    if (send_all(socket, &head, sizeof head)) send_all(socket, result.text.data(), result.text.size());
    _exit(0);
  } catch (...) {
    _exit(kEscaped);
  }
}

std::optional<ChildResult> ChildProcess::complete_result() const {
  Head head;
  if (inbox_.size() < sizeof head) return std::nullopt;
  std::memcpy(&head, inbox_.data(), sizeof head);
  if (inbox_.size() - sizeof head < head.size) return std::nullopt;
  return ChildResult{head.ok != 0, false, inbox_.substr(sizeof head)};
}

std::optional<ChildResult> ChildProcess::receive() {
  // A process that it started may hold the socket open: its end shows in the process table too.
  siginfo_t ended{};
  waitid(P_PID, static_cast<id_t>(process_), &ended, WEXITED | WNOHANG | WNOWAIT);
  const std::size_t before = inbox_.size();
  const bool open = read_some(socket_, inbox_);
  if (auto result = complete_result()) return result;
  if (open && (ended.si_pid != process_ || inbox_.size() > before)) return std::nullopt;
  return ChildResult{false, true, end()};
}

std::string ChildProcess::take_output() {
  std::string output;
  while (output_ >= 0) {
    const std::size_t before = output.size();
    const bool open = read_some(output_, output);
    if (!open) close(std::exchange(output_, -1));
    if (output.size() == before || output.size() > (1u << 20)) break;
  }
  return output;
}

void ChildProcess::interrupt() const {
  if (process_ > 0) ::kill(process_, SIGINT);
}

void ChildProcess::kill() {
  if (process_ <= 0) return;
  if (surroundings_ == Surroundings::own) ::kill(-process_, SIGKILL);
  ::kill(process_, SIGKILL);
}

/// Kills the process, which changes nothing when it is dead already, and says how it ended.
std::string ChildProcess::end() {
  kill();
  const pid_t process = std::exchange(process_, -1);
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return how_it_died(status);
}

}  // namespace meander
