// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once

// Beginnings of examples in documentation records. Macros, because only literals are joined at compile time.

/// A simulation `s` in an empty world.
#define EXAMPLE_SIM "s = meander.sim.new { world = meander.world.new { start = {2, 2, 0} } } "
/// A run `run` of two metres in it.
#define EXAMPLE_RUN EXAMPLE_SIM "run = s:drive { navigator = 'potential_field', subgoals = { {4, 2} } } "
/// A sonar reading `r` in it.
#define EXAMPLE_SCAN "r = meander.sensor.scan { world = meander.world.new { start = {2, 2, 0} } } "
