// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <lauxlib.h>

#include <array>
#include <functional>
#include <type_traits>

#include "script/kit_object.hpp"
#include "script/session.hpp"

namespace meander::script {

/// Parameter of a bound function that takes no Lua argument: the state it was called from.
struct Call {
  lua_State* L;
  Work work() const { return work_of(L); }
  void write(std::string_view text) const { script::write(L, text); }
};

/// The values that a bound function left on the Lua stack itself, for the few whose results no type describes.
struct Pushed {
  int count;
};

/// Raises the Lua error "<script position><function>: <problem>".
[[noreturn]] void raise(lua_State* L, const Record& record, const std::string& problem);
/// Raises kInterrupted.
[[noreturn]] void raise_interrupted(lua_State* L);
/// Throws "takes 2 arguments at most, got 3".
[[noreturn]] void too_many_arguments(int most, int given);

/// The one border between Lua and C++. Never catches `...`: Lua errors are exceptions of a type of Lua's own and must
/// pass; and raises after leaving the catch block.
template <class Body>
int border(lua_State* L, const Record& record, Body&& body) {
  std::string problem;
  bool interrupted = false;
  {
    const RunningScope running(L);
    try {
      return body();
    } catch (const std::exception& error) {
      problem = error.what();
    } catch (const Cancelled&) {
      interrupted = true;
    }
  }
  if (interrupted) raise_interrupted(L);
  raise(L, record, problem);
}

namespace detail {

template <class F>
struct SignatureOf;
template <class R, class... A>
struct SignatureOf<R (*)(A...)> {
  using Result = R;
  using Arguments = std::tuple<A...>;
};
template <class R, class C, class... A>
struct SignatureOf<R (C::*)(A...)> : SignatureOf<R (*)(C&, A...)> {};
template <class R, class C, class... A>
struct SignatureOf<R (C::*)(A...) const> : SignatureOf<R (*)(const C&, A...)> {};
template <class M, class C>
requires(!std::is_function_v<M>) struct SignatureOf<M C::*> : SignatureOf<const M& (*)(const C&)> {
};

template <class T>
struct Element {
  using Type = T;
};
template <class T>
struct Element<std::shared_ptr<T>> {
  using Type = T;
};

/// How a parameter of type P is read, and held during the call.
template <class P>
struct Parameter {
  using Value = std::remove_cvref_t<P>;
  static constexpr bool from_lua = true;
  static Value read(lua_State* L, int index, const Path& path) { return Lua<Value>::read(L, index, path); }
  static Value&& pass(Value& value) { return std::move(value); }
};
template <class P>
requires Object<std::remove_cvref_t<P>>
struct Parameter<P> {
  using T = std::remove_cvref_t<P>;
  using Value = std::shared_ptr<T>;
  static constexpr bool from_lua = true;
  static Value read(lua_State* L, int index, const Path& path) { return read_object<T>(L, index, path); }
  static T& pass(Value& value) { return *value; }
};
template <>
struct Parameter<Call> {
  using Value = Call;
  static constexpr bool from_lua = false;
  static Value read(lua_State* L, int, const Path&) { return {L}; }
  static Call& pass(Call& call) { return call; }
};
template <>
struct Parameter<const Call&> : Parameter<Call> {};

template <class Tuple>
struct Parameters;
template <class... P>
struct Parameters<std::tuple<P...>> {
  static constexpr std::size_t count = sizeof...(P);
  static constexpr std::size_t lua_count = (std::size_t{0} + ... + (Parameter<P>::from_lua ? 1 : 0));
  using Values = std::tuple<typename Parameter<P>::Value...>;
  /// Stack index (1 first) of each parameter.
  static constexpr std::array<int, count + 1> indices = [] {
    std::array<int, count + 1> result{};
    int next = 1;
    std::size_t i = 0;
    ((result[i++] = Parameter<P>::from_lua ? next++ : 0), ...);
    return result;
  }();
};

}  // namespace detail

template <auto F>
using SignatureOf = detail::SignatureOf<decltype(F)>;
template <auto F>
using ParametersOf = detail::Parameters<typename SignatureOf<F>::Arguments>;

/// Lua arguments of F, self included.
template <auto F>
inline constexpr std::size_t arity = ParametersOf<F>::lua_count;
template <auto F>
inline constexpr bool returns_something = !std::is_void_v<typename SignatureOf<F>::Result>;

template <class R>
int push_result(lua_State* L, const R& result) {
  if constexpr (std::is_same_v<R, Pushed>) {
    return result.count;
  } else {
    luaL_checkstack(L, 8, nullptr);
    const int before = lua_gettop(L);
    push(L, result);
    return lua_gettop(L) - before;
  }
}

/// Reads the arguments, calls F, pushes the result. A method's first parameter is its self.
template <auto F, bool is_method>
int invoke(lua_State* L, const Record& record) {
  using Arguments = typename SignatureOf<F>::Arguments;
  using P = ParametersOf<F>;
  constexpr int most = static_cast<int>(P::lua_count);
  if (lua_gettop(L) > most) too_many_arguments(most - is_method, lua_gettop(L) - is_method);
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    // Braces: from left to right.
    typename P::Values values{[&] {
      using Reader = detail::Parameter<std::tuple_element_t<I, Arguments>>;
      constexpr int index = P::indices[I];
      constexpr bool is_self = is_method && index == 1;
      const Path path{
          .kind = is_self ? Path::Kind::self : Path::Kind::argument, .index = index - 1 - is_method, .record = &record};
      return Reader::read(L, index, path);
    }()...};
    const auto call = [&]() -> decltype(auto) {
      return std::invoke(F, detail::Parameter<std::tuple_element_t<I, Arguments>>::pass(std::get<I>(values))...);
    };
    if constexpr (returns_something<F>) {
      return push_result<std::remove_cvref_t<typename SignatureOf<F>::Result>>(L, call());
    } else {
      call();
      return 0;
    }
  }
  (std::make_index_sequence<P::count>{});
}

/// The lua_CFunction of F; its first upvalue is the documentation record.
template <auto F, bool is_method>
int entry(lua_State* L) {
  const auto& record = *static_cast<const Record*>(lua_touserdata(L, lua_upvalueindex(1)));
  return border(L, record, [&] { return invoke<F, is_method>(L, record); });
}

}  // namespace meander::script
