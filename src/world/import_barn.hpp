// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "base/work.hpp"
#include "world/import_result.hpp"

namespace meander {

struct BarnOptions {
  int index = 0;
};

template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, BarnOptions>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"index", "", "which of the worlds of a BARN file", 0, 1e9}, o.index);
}

/// One world of the BARN benchmark from a table of cylinders with the columns world, x_m, y_m, radius_m. Start at
/// (-2.25, 3) looking along y, the place "goal" 10 m ahead with the benchmark's tolerance of 1 m. Throws FileError.
Imported import_barn(const std::string& csv_path, const BarnOptions& options = {}, const Work& work = {});

/// The same from text; `path` is for messages and the title.
Imported barn_from_csv(const std::string& text, const std::string& path, const BarnOptions& options = {},
                       const Work& work = {});

}  // namespace meander
