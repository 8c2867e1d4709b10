// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <lua.h>

#include <optional>
#include <string>
#include <vector>

#include "script/completion_tokens.hpp"
#include "script/docs.hpp"

namespace meander::script {

/// What an expression stands for, as far as it can be told without running it: a live value, left on the Lua stack, or
/// the type that its record promises.
struct Subject {
  bool live = false;
  std::string type{};              ///< of an object: "world"
  std::string element{};           ///< of a list of objects: their type
  const Record* record = nullptr;  ///< of a function
};

/// Looks up the expression that ends just before token `end`, such as `a.b[2]:c(1).d`, by raw access and records.
/// Nothing where it is none, or where only running it could tell.
std::optional<Subject> subject_before(lua_State* L, const std::vector<Token>& tokens, std::size_t end);

/// The opening bracket that belongs to the closing one at `closing`, or npos.
std::size_t matching_open(const std::vector<Token>& tokens, std::size_t closing);

/// The names of a live table (on top of the stack), along its chain of __index tables, or of an object's type.
/// `methods` leaves only what can be called.
std::vector<std::string> member_names(lua_State* L, const Subject& subject, bool methods);

}  // namespace meander::script
