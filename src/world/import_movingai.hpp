// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "world/import_result.hpp"
#include "world/trace.hpp"

namespace meander {

struct MovingAiOptions {
  double resolution = 0.05;  ///< the format has no unit: side of a cell [m]
  TraceOptions trace;
};

/// The blocked cells of a map of movingai.com, traced: trees, water and what is out of bounds. Throws FileError.
Imported import_movingai(const std::string& path, const MovingAiOptions& options = {}, const Work& work = {});
/// The same from the file's text; `path` names it in messages.
Imported movingai_from_text(const std::string& text, const std::string& path, const MovingAiOptions& options = {},
                            const Work& work = {});

}  // namespace meander
