// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <lua.h>

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "script/sandbox.hpp"

namespace meander::script {

/// What one Lua state in a sandbox has used, and where it ends. Computing time is not counted here: a program that
/// opens a sandbox starts the clock of script/sandbox_clock.hpp.
class Sandbox {
 public:
  /// A count hook comes so often [Lua instructions]; coroutines are charged as much when they start, because each has
  /// a counter of its own.
  static constexpr int kStep = 250;

  explicit Sandbox(const SandboxOptions& options);
  ~Sandbox();
  Sandbox(const Sandbox&) = delete;
  Sandbox& operator=(const Sandbox&) = delete;

  const SandboxOptions& options() const { return options_; }
  /// Without symbolic links.
  const std::filesystem::path& folder() const { return folder_; }

  /// The lua_Alloc; `sandbox` is the address of a Sandbox.
  static void* allocate(void* sandbox, void* block, std::size_t old_size, std::size_t new_size);
  /// Looks at how much native objects hold now; collects garbage when the limit is near.
  void measure(lua_State* L);
  /// A native object of this size was made: measures now and then.
  void add_native(lua_State* L, std::size_t bytes);
  /// In a forked worker, one of `count` at a time: its share of what memory is left, and no workers of its own.
  void become_worker(int count);
  bool is_worker() const { return worker_; }

  /// Counts instructions, of this process and its workers together. False when none are left.
  bool spend(int instructions);
  /// Counts text and files that are written; throws Error when it is too much.
  void charge_output(std::size_t bytes);
  /// The file is about to be written; its size is charged at the next call of this.
  void charge_file(const std::string& path);

  /// The script asks to end, as os.exit does. Nothing of it may run any more.
  void leave(int code) { exit_code_ = code; }
  std::optional<int> exit_code() const { return exit_code_; }
  /// Why nothing may run any more; empty when it may.
  std::string verdict() const;

 private:
  std::size_t in_use() const { return lua_bytes_ + native_bytes_; }
  std::size_t native_now() const;

  SandboxOptions options_;
  std::filesystem::path folder_;
  std::size_t limit_;  ///< bytes
  std::size_t lua_bytes_ = 0;
  std::size_t native_bytes_ = 0;
  std::size_t bytes_at_start_;  ///< that the process had taken before
  std::size_t next_collection_;
  std::size_t unmeasured_ = 0;  ///< bytes made since
  /// Shared with workers.
  struct Shared {
    std::atomic<std::int64_t> instructions{0};
    std::atomic<std::size_t> written{0};
  };
  Shared* shared_;
  std::string last_file_;
  std::optional<int> exit_code_;
  bool worker_ = false;
};

/// The hook of a state in a sandbox while nothing stops it; none for other states.
void set_resting_hook(lua_State* L);
/// For coroutines that start; they are stopped at their first instruction when none is left.
void charge_coroutine(lua_State* L);

}  // namespace meander::script
