// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <utility>
#include <vector>

namespace meander {

/// Share of the pairs of a true and a false case in which the true one has the higher score; ties count half. No number
/// where one of the two kinds is missing.
double area_under_curve(std::vector<std::pair<double, bool>> scored);

}  // namespace meander
