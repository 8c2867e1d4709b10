// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "script/kit_doc.hpp"

namespace meander::script {

/// Is the value at `index` a module table of the bindings?
bool is_module(lua_State* L, int index);
/// The record of a bound function, module or object at `index`, or nullptr.
const Record* record_of(lua_State* L, int index);

/// Ties the function or table on top of the stack to its record, for record_of().
void remember_record(lua_State* L, const Record& record);

/// A table of bound functions: `meander.sim`. The empty path stands for the globals.
class Module {
 public:
  /// Finds or makes the table; `text` says in a sentence what it offers.
  Module(lua_State* L, const char* path, const char* text);

  template <auto F>
  Module& function(CompleteDoc<arity<F>, returns_something<F>> doc) {
    add(make_record<F, false>(doc.doc, path_), entry<F, false>);
    return *this;
  }

 private:
  void add(Record record, lua_CFunction function);
  lua_State* L_;
  const char* path_;
};

}  // namespace meander::script
