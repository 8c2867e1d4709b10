// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <functional>
#include <string_view>

namespace meander {

/// Shows on one line of the terminal behind stderr how far long work is and how long it will take. Work that ends soon
/// shows nothing; a fraction of 1 takes the line away, one below 0 as well, but only until the next report: something
/// else is about to be written. What follows a tab in the label stands behind the bar instead of percents. Empty where
/// stderr is no terminal that can rewrite a line.
std::function<void(double fraction, std::string_view label)> progress_line();

}  // namespace meander
