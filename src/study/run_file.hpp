// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "study/run.hpp"

namespace meander {

/// The run's figures as one line of JSON (no steps): reached, subgoals, contacts, time, length, clearance_min, hash,
/// ... Times in s, lengths in m; the hashes are hexadecimal texts.
std::string summary_json(const Run& run);

/// One row per recorded step, with a head row. Atomic; throws FileError.
void save_csv(const Run& run, const std::string& path);

/// JSON lines: a head (format, version, seed, options, world hash, goals), one line per step, and the figures at the
/// end. Atomic; throws FileError.
void save_jsonl(const Run& run, const std::string& path);

}  // namespace meander
