// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstdint>
#include <string>

#include "base/fields.hpp"

namespace meander::script {

/// What a script of somebody else may use.
struct SandboxOptions {
  std::string folder = ".";                   ///< the only place it may read and write
  double memory = 512;                        ///< of Lua and of native objects together
  std::int64_t instructions = 2'000'000'000;  ///< Lua instructions in all
  double seconds = 60;                        ///< computing time in all
  double output = 256;                        ///< text and files written in all
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, SandboxOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"folder", "", "the only place where the script may read and write files"}, o.folder);
  visit(Field{"memory", "MiB", "memory of Lua and of native objects together", 16, 1e6}, o.memory);
  visit(Field{"instructions", "", "Lua instructions in all", 1000, 1e15}, o.instructions);
  visit(Field{"seconds", "s", "computing time in all", 0.1, 1e6}, o.seconds);
  visit(Field{"output", "MiB", "text and files that it writes in all", 1, 1e6}, o.output);
}

}  // namespace meander::script
