// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/sandbox_state.hpp"

#include <malloc.h>
#include <sys/mman.h>

#include <algorithm>
#include <cstdlib>
#include <new>

#include "base/error.hpp"
#include "script/lua_interrupt.hpp"
#include "script/sandbox_clock.hpp"
#include "script/session.hpp"

namespace meander::script {
namespace {

constexpr double kMebibyte = 1024 * 1024;
/// Native memory is looked at so often [hooks]: every 100,000 instructions.
constexpr std::int64_t kHooksPerMeasurement = 400;

/// What malloc has given out.
std::size_t bytes_taken() {
  const auto info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

std::filesystem::path real_folder(const std::string& folder) {
  std::error_code failed;
  const auto real = std::filesystem::canonical(folder, failed);
  if (failed) fail<Error>("sandbox: folder '{}': {}", folder, failed.message());
  if (!std::filesystem::is_directory(real, failed)) fail<Error>("sandbox: '{}' is no folder", folder);
  return real;
}

void* shared_memory(std::size_t size) {
  void* page = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (page == MAP_FAILED) throw std::bad_alloc();
  return page;
}

void count(lua_State* L, lua_Debug* activation) {
  Sandbox& sandbox = *session(L).sandbox;
  thread_local std::int64_t hooks = 0;
  if (sandbox.spend(Sandbox::kStep)) {
    if (++hooks % kHooksPerMeasurement == 0) sandbox.measure(L);
    return;
  }
  stop_running();
  raise_stop(L, activation);
}

}  // namespace

Sandbox::Sandbox(const SandboxOptions& options)
    : options_(options),
      folder_(real_folder(options.folder)),
      limit_(static_cast<std::size_t>(options.memory * kMebibyte)),
      bytes_at_start_(bytes_taken()),
      next_collection_(limit_ / 4 * 3),
      shared_(new (shared_memory(sizeof(Shared))) Shared) {}

Sandbox::~Sandbox() { munmap(shared_, sizeof *shared_); }

void* Sandbox::allocate(void* sandbox, void* block, std::size_t old_size, std::size_t new_size) {
  auto& self = *static_cast<Sandbox*>(sandbox);
  const std::size_t before = block ? old_size : 0;  // of a new block it is the kind of object
  if (new_size > before && self.in_use() + (new_size - before) > self.limit_) return nullptr;
  void* moved = nullptr;
  if (new_size == 0)
    std::free(block);
  else if (moved = std::realloc(block, new_size); !moved)
    return nullptr;
  self.lua_bytes_ += new_size - before;
  return moved;
}

/// Freed since the start counts for nothing.
std::size_t Sandbox::native_now() const {
  const std::size_t others = bytes_at_start_ + lua_bytes_;
  return std::max(bytes_taken(), others) - others;
}

void Sandbox::measure(lua_State* L) {
  native_bytes_ = native_now();
  unmeasured_ = 0;
  if (in_use() < next_collection_) return;
  lua_gc(L, LUA_GCCOLLECT);
  native_bytes_ = native_now();
  next_collection_ = std::clamp(in_use() + in_use() / 8, limit_ / 4 * 3, limit_);
}

void Sandbox::add_native(lua_State* L, std::size_t bytes) {
  unmeasured_ += bytes;
  if (unmeasured_ >= limit_ / 64) measure(L);
}

void Sandbox::become_worker(int count) {
  worker_ = true;
  silence_clock();
  native_bytes_ = native_now();
  const std::size_t used = std::min(in_use(), limit_);
  limit_ = used + (limit_ - used) / static_cast<std::size_t>(std::max(count, 1));
  next_collection_ = used + (limit_ - used) / 4 * 3;
}

bool Sandbox::spend(int instructions) {
  return shared_->instructions.fetch_add(instructions, std::memory_order_relaxed) + instructions <=
         options_.instructions;
}

void Sandbox::charge_output(std::size_t bytes) {
  const std::size_t written = shared_->written += bytes;
  if (static_cast<double>(written) > options_.output * kMebibyte)
    fail<Error>("sandbox: more than {} MiB written", options_.output);
}

void Sandbox::charge_file(const std::string& path) {
  constexpr std::size_t kEntry = 4096;  // an empty file takes room too
  std::error_code none;
  const auto size = last_file_.empty() ? 0 : std::filesystem::file_size(last_file_, none);
  last_file_ = path;
  charge_output(kEntry + (none ? 0 : static_cast<std::size_t>(size)));
}

std::string Sandbox::verdict() const {
  if (exit_code_) return "ended by os.exit";
  if (const char* late = clock_verdict()) return late;
  if (shared_->instructions.load(std::memory_order_relaxed) > options_.instructions)
    return fmt::format("sandbox: {} Lua instructions used up", options_.instructions);
  return {};
}

void set_resting_hook(lua_State* L) {
  if (session(L).sandbox)
    lua_sethook(L, count, LUA_MASKCOUNT, Sandbox::kStep);
  else
    lua_sethook(L, nullptr, 0, 0);
}

void charge_coroutine(lua_State* L) {
  if (!session(L).sandbox || session(L).sandbox->spend(Sandbox::kStep)) return;
  stop_running();
}

}  // namespace meander::script
