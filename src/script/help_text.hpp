// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "script/docs.hpp"

namespace meander::script {

/// What help(x) writes, in lines of `width` characters but for the example (0: however long they are).
std::string help_text(const Docs& docs, const Record& record, std::size_t width = 0);
/// Modules, types and global functions, a line each.
std::string overview_text(const Docs& docs);
/// A line for each record: its signature and its text.
std::string list_text(const std::vector<const Record*>& records);
/// Everything whose name, text or options contain the word, whatever its case; empty where there is nothing.
std::string apropos_text(const Docs& docs, std::string_view word);

/// A type in which "name" is replaced by the names there are: "'a' | 'b' or table of options".
std::string type_in_words(const std::string& type, const std::vector<std::string>& values);
/// Tells two tables of options apart: by their name and those of their keys.
std::string shape_of(const OptionDoc& option);

/// By full name, or by the name without "meander." in front.
const Record* find_record(const Docs& docs, std::string_view name);
std::vector<std::string> record_names(const Docs& docs);

}  // namespace meander::script
