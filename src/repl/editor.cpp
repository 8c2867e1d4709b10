// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "repl/editor.hpp"

#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/error.hpp"
#include "base/text_file.hpp"

namespace meander::repl {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostText = 16u << 20;
constexpr int kNotFound = 127;  ///< exit code of the shell

bool on_path(const std::string& program) {
  const char* folders = std::getenv("PATH");
  std::istringstream list(folders ? folders : "");
  for (std::string folder; std::getline(list, folder, ':');)
    if (access((fs::path(folder) / program).c_str(), X_OK) == 0) return true;
  return false;
}

std::string editor_command() {
  for (const char* variable : {"VISUAL", "EDITOR"})
    if (const char* command = std::getenv(variable); command && *command) return command;
  for (const char* standard : {"editor", "nano", "vi"})
    if (on_path(standard)) return standard;
  fail<Error>("no editor: set VISUAL or EDITOR to the one you like, in the shell: export EDITOR=nano");
}

/// Ctrl-C and Ctrl-\ go to all programs on the terminal: they are meant for the editor only while this lives.
class DeafToKeys {
 public:
  DeafToKeys() {
    struct sigaction ignore {};
    ignore.sa_handler = SIG_IGN;
    for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &ignore, &before_[i]);
  }
  ~DeafToKeys() { hear(); }
  DeafToKeys(const DeafToKeys&) = delete;
  DeafToKeys& operator=(const DeafToKeys&) = delete;

  void hear() const {
    for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before_[i], nullptr);
  }

 private:
  static constexpr std::array kSignals = {SIGINT, SIGQUIT};
  std::array<struct sigaction, kSignals.size()> before_;
};

/// Puts back what an editor that crashed may have left.
class TerminalKept {
 public:
  TerminalKept() : known_(tcgetattr(STDIN_FILENO, &mode_) == 0) {}
  ~TerminalKept() {
    if (known_) tcsetattr(STDIN_FILENO, TCSADRAIN, &mode_);
  }
  TerminalKept(const TerminalKept&) = delete;
  TerminalKept& operator=(const TerminalKept&) = delete;

 private:
  termios mode_{};
  bool known_;
};

/// The status of waitpid. The command may have arguments, so the shell takes it apart.
int run(const std::string& command, const std::string& path) {
  const DeafToKeys deaf;
  const TerminalKept kept;
  const std::string line = "exec " + command + " \"$@\"";  // no shell in between that Ctrl-C would end
  const pid_t child = fork();
  if (child < 0) fail<Error>("no process for the editor '{}'", command);
  if (child == 0) {
    deaf.hear();
    execl("/bin/sh", "sh", "-c", line.c_str(), "sh", path.c_str(), nullptr);
    _exit(kNotFound);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  return status;
}

/// A file of the user's own, gone at the end.
class PrivateFile {
 public:
  explicit PrivateFile(const std::string& text) {
    path_ = (fs::temp_directory_path() / "meander-XXXXXX.lua").string();
    const int file = mkstemps(path_.data(), 4);  // mode 0600
    if (file < 0) fail<FileError>("{}: cannot be made", path_);
    close(file);
    std::ofstream out(path_, std::ios::binary);
    if (!(out << text << '\n').flush()) fail<FileError>("{}: cannot be written", path_);
  }
  ~PrivateFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  PrivateFile(const PrivateFile&) = delete;
  PrivateFile& operator=(const PrivateFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace

void edit_file(const std::string& path) {
  const std::string command = editor_command();
  const int status = run(command, path);
  if (WIFSIGNALED(status)) fail<Error>("the editor '{}' was ended by signal {}", command, WTERMSIG(status));
  const int code = WEXITSTATUS(status);
  if (code == kNotFound) fail<Error>("no editor '{}'; VISUAL and EDITOR name the one to use", command);
  if (code != 0) fail<Error>("the editor '{}' failed with exit code {}", command, code);
}

std::string edit_text(const std::string& text) {
  const PrivateFile file(text);
  edit_file(file.path());
  std::string edited = read_text_file(file.path(), kMostText);
  while (!edited.empty() && (edited.back() == '\n' || edited.back() == '\r')) edited.pop_back();
  return edited;
}

}  // namespace meander::repl
