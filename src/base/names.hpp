// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meander {

/// The candidate that differs least from `name` (Damerau-Levenshtein distance, at most a third of its length), if any.
std::optional<std::string> nearest_name(std::string_view name, const std::vector<std::string>& candidates);

/// "; did you mean 'x'?" or an empty text.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates);

/// "a, b, c", cut after `most` names with ", ...".
std::string listing(const std::vector<std::string>& names, std::size_t most = 12);

}  // namespace meander
