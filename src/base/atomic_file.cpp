// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <filesystem>
#include <optional>
#include <system_error>

#include "base/error.hpp"

namespace meander {
namespace {

[[noreturn]] void refuse(const std::string& path, int error) {
  const auto folder = std::filesystem::path(path).parent_path();
  std::error_code ignored;
  if (error == ENOENT && !folder.empty() && !std::filesystem::exists(folder, ignored))
    fail<FileError>("{}: cannot be written: there is no folder '{}'", path, folder.string());
  fail<FileError>("{}: cannot be written: {}", path, std::generic_category().message(error));
}

/// An open file that is closed in any case.
struct Descriptor {
  int number = -1;
  explicit Descriptor(int n) : number(n) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
};

/// 0 or the errno of the write that failed.
int write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    if (written == 0) return EIO;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

/// Devices and pipes cannot be replaced by renaming.
void write_directly(const std::string& path, std::string_view text) {
  const Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (file.number < 0) refuse(path, errno);
  if (const int error = write_all(file.number, text)) refuse(path, error);
}

/// Writes the temporary file down to the disk; 0 or the errno.
int fill(int file, std::string_view text, std::optional<mode_t> mode) {
  if (mode && ::fchmod(file, *mode) != 0) return errno;
  if (const int error = write_all(file, text)) return error;
  return ::fsync(file) == 0 ? 0 : errno;
}

/// Where a path leads by symbolic links of its last name, also when nothing is there yet.
std::string end_of_links(const std::string& path) {
  constexpr int kMostLinks = 40;  // as the system follows
  std::filesystem::path target = path;
  std::error_code none;
  for (int i = 0; i < kMostLinks; ++i) {
    const auto next = std::filesystem::read_symlink(target, none);
    if (none) return target.string();
    target = target.parent_path() / next;  // an absolute one replaces all
  }
  refuse(path, ELOOP);
}

/// A new file beside `target`; -1 with errno when the folder does not allow it. Its name is short, because a name as
/// long as the system allows leaves no room for more.
int open_beside(const std::string& target, std::string& name) {
  static std::atomic<unsigned> counter{0};
  for (;;) {
    const std::string last = fmt::format(".meander.{}.{}.tmp", ::getpid(), counter++);
    name = std::filesystem::path(target).replace_filename(last).string();
    const int file = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file >= 0 || errno != EEXIST) return file;
  }
}

/// After this the new name survives a power cut. Not every file system offers it, and the content is safe already.
void sync_folder_of(const std::string& target) {
  const auto folder = std::filesystem::path(target).parent_path();
  const Descriptor file(::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (file.number >= 0) static_cast<void>(::fsync(file.number));
}

void replace(const std::string& path, const std::string& target, std::string_view text, std::optional<mode_t> mode) {
  std::string temporary;
  int error = 0;
  {
    const Descriptor file(open_beside(target, temporary));
    if (file.number < 0) refuse(path, errno);
    error = fill(file.number, text, mode);
  }
  if (!error && ::rename(temporary.c_str(), target.c_str()) != 0) error = errno;
  if (error) {
    ::unlink(temporary.c_str());
    refuse(path, error);
  }
  sync_folder_of(target);
}

}  // namespace

void check_writable(const std::string& path) {
  const auto folder = std::filesystem::path(path).parent_path();
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) refuse(path, EISDIR);
  const bool device = std::filesystem::is_other(path, ignored);
  if (::access(device ? path.c_str() : folder.empty() ? "." : folder.c_str(), W_OK) != 0) refuse(path, errno);
}

void write_file_atomically(const std::string& path, std::string_view text) {
  if (path.find('\0') != std::string::npos)
    fail<FileError>("{}: cannot be written: zero byte in the name", path.c_str());
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) {
    if (errno != ENOENT) refuse(path, errno);
    const std::string target = end_of_links(path);
    if (!std::filesystem::path(target).has_filename()) refuse(path, ENOENT);
    return replace(path, target, text, std::nullopt);
  }
  if (S_ISDIR(status.st_mode)) refuse(path, EISDIR);
  if (!S_ISREG(status.st_mode)) return write_directly(path, text);
  if (::access(path.c_str(), W_OK) != 0) refuse(path, errno);
  replace(path, end_of_links(path), text, status.st_mode & 07777);
}

}  // namespace meander
