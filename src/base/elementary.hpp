// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once

namespace meander {

/// e^x with the same bits on every machine; within 2 units in the last place. 0 below -708, infinite above 709.
double exponential(double x);

/// Natural logarithm with the same bits on every machine, of positive finite normal numbers; within 2 units in the last
/// place, or 3e-16 near 1.
double logarithm(double x);

}  // namespace meander
