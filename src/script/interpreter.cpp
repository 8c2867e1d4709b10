// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/interpreter.hpp"

#include <lauxlib.h>
#include <lua.h>
#include <lualib.h>

#include <filesystem>
#include <new>

#include "script/bindings.hpp"
#include "script/file_access.hpp"
#include "script/kit_module.hpp"
#include "script/lua_interrupt.hpp"
#include "script/lua_setup.hpp"
#include "script/pretty.hpp"
#include "script/sandbox_libraries.hpp"
#include "script/sandbox_state.hpp"

namespace meander::script {
namespace {

/// math.random starts from the clock in Lua 5.4: two runs of the same script would differ.
void seed_library_random(lua_State* L) {
  lua_getglobal(L, "math");
  lua_getfield(L, -1, "randomseed");
  lua_pushinteger(L, 1);
  lua_call(L, 1, 0);
  lua_pop(L, 1);
}

/// Everything that may raise while the state is set up; argument 1 is the folder of --lua-dir.
int set_up(lua_State* L) {
  lua_pushboolean(L, true);
  lua_setfield(L, LUA_REGISTRYINDEX, "LUA_NOENV");  // LUA_PATH would make runs depend on the machine
  luaL_openlibs(L);
  open_modules(L, lua_tostring(L, 1));
  set_module_folder(L, ".");
  open_threads(L);
  seed_library_random(L);
  if (session(L).sandbox) keep_safe_libraries(L);
  bind_all(L);
  open_pretty(L);
  open_strict(L);
  set_resting_hook(L);
  return 0;
}

/// Old hands type "= x".
std::string as_expression(const std::string& typed) {
  const std::size_t start = typed.find_first_not_of(" \t");
  const bool marked = start != std::string::npos && typed[start] == '=';
  return "return " + (marked ? typed.substr(start + 1) : typed);
}

bool ends_in_eof(lua_State* L) {
  constexpr std::string_view kMark = "<eof>";
  const std::string message = pop_text(L);
  return message.ends_with(kMark);
}

/// require(name), kept as a global named like the last part of the name.
int require_global(lua_State* L) {
  lua_getglobal(L, "require");
  lua_pushvalue(L, 1);
  lua_call(L, 1, 1);
  const std::string_view name = lua_tostring(L, 1);
  lua_setglobal(L, name.substr(name.rfind('.') + 1).data());
  return 0;
}

/// A lone function or module of meander tells what it is.
bool push_record_line(lua_State* L) {
  const bool alone = lua_gettop(L) == 1 && (lua_isfunction(L, 1) || is_module(L, 1));
  const Record* record = alone ? record_of(L, 1) : nullptr;
  if (!record) return false;
  const char* more = record->kind == DocKind::module ? " help(...) lists it." : "";
  lua_pushfstring(L, "%s  %s%s", record->signature().c_str(), record->text.c_str(), more);
  return true;
}

/// The values as text. The first one, unless it is nil, becomes `_`.
int echo_values(lua_State* L) {
  const int count = lua_gettop(L);
  if (!lua_isnil(L, 1)) {
    lua_pushvalue(L, 1);
    lua_setglobal(L, "_");
  }
  if (push_record_line(L)) return 1;
  if (!push_pretty(L, "echo")) return luaL_error(L, "meander.pretty.echo is gone");
  lua_insert(L, 1);
  lua_call(L, count, 1);
  return 1;
}

/// A script that was at its end has failed, whatever it made of the error.
void judge(const Sandbox& sandbox, Outcome& outcome) {
  const std::string verdict = sandbox.verdict();
  if (outcome.message.ends_with("not enough memory"))
    outcome.message += fmt::format(" (sandbox: {} MiB)", sandbox.options().memory);
  if (verdict.empty()) return;
  outcome.kind = Outcome::Kind::failed;
  outcome.exit_code = sandbox.exit_code();
  if (!outcome.message.ends_with(verdict)) outcome.message = verdict;
}

/// Nothing else can fail outside of a protected call.
int out_of_memory(lua_State*) { throw Error("sandbox: not enough memory"); }

}  // namespace

Interpreter::Interpreter(const InterpreterOptions& options) {
  if (options.sandbox) session_.sandbox = std::make_shared<Sandbox>(*options.sandbox);
  L_ = session_.sandbox ? lua_newstate(Sandbox::allocate, session_.sandbox.get()) : luaL_newstate();
  if (!L_) throw std::bad_alloc();
  if (session_.sandbox) lua_atpanic(L_, out_of_memory);
  attach(L_, session_);
  lua_pushcfunction(L_, set_up);
  lua_pushlstring(L_, options.lua_dir.data(), options.lua_dir.size());
  ErrorReport report;
  if (call_reporting(L_, 1, report)) return;
  lua_close(L_);
  fail<Error>("{}", report.message);
}

Interpreter::~Interpreter() {
  release_interrupt_signal();
  lua_close(L_);
}

void Interpreter::set_arguments(const std::string& script, const std::vector<std::string>& arguments) {
  lua_createtable(L_, static_cast<int>(arguments.size()), 1);
  lua_pushlstring(L_, script.data(), script.size());
  lua_rawseti(L_, -2, 0);
  lua_Integer index = 0;
  for (const std::string& argument : arguments) {
    lua_pushlstring(L_, argument.data(), argument.size());
    lua_rawseti(L_, -2, ++index);
  }
  lua_setglobal(L_, "arg");
}

std::string Interpreter::permitted_path(const std::string& name, bool reads) const {
  if (!session_.sandbox) return name;
  return reads ? path_to_read(L_, name) : path_to_write(L_, name);
}

int Interpreter::push_arguments() {
  lua_getglobal(L_, "arg");
  if (!lua_istable(L_, -1)) return lua_pop(L_, 1), 0;
  const int count = static_cast<int>(lua_rawlen(L_, -1));
  luaL_checkstack(L_, count, "too many arguments");
  for (int i = 1; i <= count; ++i) lua_rawgeti(L_, -i, i);
  lua_remove(L_, -(count + 1));
  return count;
}

Outcome Interpreter::load_failure(const std::string& path) {
  Outcome outcome;
  outcome.kind = Outcome::Kind::failed;
  outcome.message = pop_text(L_);
  if (outcome.message.starts_with("attempt to load a binary"))
    outcome.message = path + ": compiled Lua; scripts are texts";
  return outcome;
}

bool Interpreter::ended() const { return session_.sandbox && !session_.sandbox->verdict().empty(); }

Outcome Interpreter::run_loaded(int arguments, bool echo) {
  if (ended()) {
    Outcome outcome;
    judge(*session_.sandbox, outcome);
    lua_pop(L_, arguments + 1);
    return outcome;
  }
  const InterruptScope scope(L_, session_.stop);
  const int first = lua_gettop(L_) - arguments;
  Outcome outcome;
  bool done = call_reporting(L_, arguments, outcome);
  if (done && echo && lua_gettop(L_) >= first) {
    lua_pushcfunction(L_, echo_values);
    lua_insert(L_, first);
    done = call_reporting(L_, lua_gettop(L_) - first, outcome);
    if (done) outcome.echo = pop_text(L_);
  }
  if (session_.progress) session_.progress(1, "");
  if (!done) outcome.kind = Outcome::Kind::failed;
  if (session_.stop.requested()) outcome.kind = Outcome::Kind::interrupted;
  if (session_.sandbox) judge(*session_.sandbox, outcome);
  lua_settop(L_, first - 1);
  return outcome;
}

Outcome Interpreter::run_main(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  set_module_folder(L_, folder.empty() ? "." : folder);
  if (luaL_loadfilex(L_, path.c_str(), "t") != LUA_OK) return load_failure(path);
  return run_loaded(push_arguments());
}

Outcome Interpreter::run_input() {
  if (luaL_loadfilex(L_, nullptr, "t") != LUA_OK) return load_failure();
  return run_loaded(push_arguments());
}

Outcome Interpreter::run_file(const std::string& path) {
  if (luaL_loadfilex(L_, path.c_str(), "t") != LUA_OK) return load_failure(path);
  return run_loaded(0);
}

bool Interpreter::load(const std::string& code, const char* chunk) {
  return luaL_loadbufferx(L_, code.data(), code.size(), chunk, "t") == LUA_OK;
}

Outcome Interpreter::run_text(const std::string& code, const char* chunk) {
  return load(code, chunk) ? run_loaded(0) : load_failure();
}

Outcome Interpreter::load_module(const std::string& module) {
  lua_pushcfunction(L_, require_global);
  lua_pushlstring(L_, module.data(), module.size());
  return run_loaded(1);
}

bool Interpreter::incomplete(const std::string& text) const {
  bool open = false;
  for (const std::string& form : {as_expression(text), text}) {
    if (luaL_loadbufferx(L_, form.data(), form.size(), kPromptChunk, "t") == LUA_OK) return lua_pop(L_, 1), false;
    open = ends_in_eof(L_) || open;
  }
  return open;
}

Outcome Interpreter::evaluate(const std::string& text) {
  const bool value = load(as_expression(text), kPromptChunk);
  const bool statement = load(text, kPromptChunk);
  if (value)
    lua_pop(L_, 1);
  else
    lua_remove(L_, -2);
  if (!value && !statement) return load_failure();
  Outcome outcome = run_loaded(0, true);
  outcome.value = value;
  outcome.statement = statement;
  return outcome;
}

std::vector<std::string> Interpreter::declarations() const { return script::declarations(L_); }

Completion Interpreter::complete(std::string_view text) const { return script::complete(L_, text); }

}  // namespace meander::script
