// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "script/docs.hpp"

namespace meander::script {

/// What the words of a type text stand for in one place.
struct TypeWords {
  const Docs& docs;
  std::string table = "table";  ///< what "table" and "table of options" are: the class of an option table
  std::string name = "string";  ///< what "name" is: the alias of the names there are
};

/// A type as records tell it to people ("list of thing", "{x, y} or place", "'stop' | 'skip'"), as annotations for
/// the Lua language server have it ("thing[]", "meander.point|thing|string"). What it does not know is "unknown".
std::string type_annotation(std::string_view type, const TypeWords& words);
/// The results of a call, one annotation each: "world, list of string" are two, "thing, name or nil" is one.
std::vector<std::string> result_annotations(std::string_view type, const TypeWords& words);
/// "fun(observation: observation, subgoal: any): any" for a text that begins with "function(observation, subgoal)".
std::string function_annotation(std::string_view text, const Docs& docs);

/// The classes of points that every annotation may name.
std::string point_classes();

}  // namespace meander::script
