// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>

#include "app/confine.hpp"
#include "base/data_folder.hpp"

namespace meander {
namespace {

// What headers older than the kernel do not name.
constexpr std::uint64_t kRefer = 1ull << 13;                                 // ABI 2
constexpr std::uint64_t kTruncate = 1ull << 14;                              // ABI 3
constexpr std::uint64_t kDevices = 1ull << 15;                               // ABI 5
constexpr std::uint64_t kBindTcp = 1ull << 0, kConnectTcp = 1ull << 1;       // ABI 4
constexpr std::uint64_t kAbstractSockets = 1ull << 0, kSignals = 1ull << 1;  // ABI 6

/// landlock_ruleset_attr as it is since ABI 6; kernels before take its first part.
struct Ruleset {
  std::uint64_t files;
  std::uint64_t network;
  std::uint64_t scoped;
};

constexpr std::uint64_t kReadFile = LANDLOCK_ACCESS_FS_READ_FILE;
constexpr std::uint64_t kRead = kReadFile | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t kWriteFile = LANDLOCK_ACCESS_FS_WRITE_FILE | kTruncate;
constexpr std::uint64_t kWrite = kWriteFile | LANDLOCK_ACCESS_FS_MAKE_REG | LANDLOCK_ACCESS_FS_MAKE_DIR |
                                 LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_REMOVE_DIR | kRefer;
constexpr std::uint64_t kOnFiles = kReadFile | kWriteFile;

/// All rights over files that Landlock of this version can take away.
std::uint64_t known_rights(long version) {
  std::uint64_t rights = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1) - 1;
  if (version >= 2) rights |= kRefer;
  if (version >= 3) rights |= kTruncate;
  if (version >= 5) rights |= kDevices;
  return rights;
}

class Rules {
 public:
  explicit Rules(long version) : known_(known_rights(version)) {
    const Ruleset ruleset{known_, version >= 4 ? kBindTcp | kConnectTcp : 0,
                          version >= 6 ? kAbstractSockets | kSignals : 0};
    const std::size_t size = version >= 6   ? sizeof ruleset
                             : version >= 4 ? offsetof(Ruleset, scoped)
                                            : sizeof ruleset.files;
    descriptor_ = static_cast<int>(syscall(SYS_landlock_create_ruleset, &ruleset, size, 0));
  }
  ~Rules() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  Rules(const Rules&) = delete;
  Rules& operator=(const Rules&) = delete;

  /// What is not there needs no rule.
  void allow(const std::string& path, std::uint64_t rights) const {
    const int place = open(path.c_str(), O_PATH | O_CLOEXEC);
    if (place < 0) return;
    struct stat status {};
    fstat(place, &status);
    if (!S_ISDIR(status.st_mode)) rights &= kOnFiles;
    landlock_path_beneath_attr rule{};
    rule.allowed_access = rights & known_;
    rule.parent_fd = place;
    syscall(SYS_landlock_add_rule, descriptor_, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
    close(place);
  }
  bool enforce() const { return descriptor_ >= 0 && syscall(SYS_landlock_restrict_self, descriptor_, 0) == 0; }

 private:
  std::uint64_t known_;
  int descriptor_ = -1;
};

}  // namespace

bool confine_files(const std::string& folder, const std::vector<std::string>& readable) {
  const long version = syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  if (version < 1) return false;
  const Rules rules(version);
  rules.allow(folder, kRead | kWrite);
  for (const std::string& path : readable) rules.allow(path, kRead);
  if (const std::string data = data_folder(); !data.empty()) rules.allow(data, kRead);
  for (const std::string& path : beside_program("lib/meander")) rules.allow(path, kRead);
  // The codec module and the libraries it needs are loaded at their first use; terminals and times of day have files.
  for (const char* path : {"/lib", "/lib64", "/usr/lib", "/usr/lib64", "/usr/local/lib", "/usr/share/terminfo",
                           "/usr/share/zoneinfo", "/etc/ld.so.cache", "/etc/terminfo", "/etc/localtime"})
    rules.allow(path, kRead);
  for (const char* path : {"/dev/null", "/dev/tty"}) rules.allow(path, kReadFile | kWriteFile);
  rules.allow("/dev/urandom", kReadFile);
  return rules.enforce();
}

}  // namespace meander
