// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <lauxlib.h>

#include <memory>
#include <string>

#include "script/kit_value.hpp"
#include "script/session.hpp"

namespace meander::script {

/// A Lua value kept alive by native code. Safe to destroy after the state was closed.
class Reference {
 public:
  /// Takes the value on top of the stack.
  explicit Reference(lua_State* L);
  ~Reference();
  Reference(const Reference&) = delete;
  Reference& operator=(const Reference&) = delete;

  /// Pushes the value onto the stack of the coroutine that runs now and returns that; throws when the state is closed.
  lua_State* push() const;

 private:
  std::shared_ptr<StateLife> life_;
  int key_;
};

/// A Lua function as a C++ callable, for std::function. An error in it travels as the Lua error it is, through the C++
/// frames in between, to the script's next pcall: they must be exception-safe, and are.
class Function {
 public:
  Function() = default;
  Function(lua_State* L, int index, const Path& path);
  explicit operator bool() const { return reference_ != nullptr; }

  /// Pushes the function for a call by hand.
  lua_State* push() const { return reference_->push(); }
  /// Calls with the arguments, leaves `results` values on the stack of the returned coroutine.
  template <class... A>
  lua_State* invoke(int results, const A&... arguments) const {
    lua_State* L = reference_->push();
    luaL_checkstack(L, static_cast<int>(sizeof...(A)) + results + 1, nullptr);
    (script::push(L, arguments), ...);
    lua_call(L, static_cast<int>(sizeof...(A)), results);
    return L;
  }
  template <class... A>
  void call(const A&... arguments) const {
    invoke(0, arguments...);
  }
  template <class R, class... A>
  R get(const A&... arguments) const {
    lua_State* L = invoke(1, arguments...);
    R result = Lua<R>::read(L, -1, result_path());
    lua_pop(L, 1);
    return result;
  }
  /// Names results in messages: "option 'navigator': result".
  Path result_path() const { return {.kind = Path::Kind::value, .name = label_->c_str()}; }

 private:
  std::shared_ptr<const Reference> reference_;
  std::shared_ptr<const std::string> label_;
};

template <>
struct Lua<Function> {
  static Function read(lua_State* L, int index, const Path& path) { return Function(L, index, path); }
  static std::string type() { return "function"; }
};

}  // namespace meander::script
