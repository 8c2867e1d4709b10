// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>
#include <string>

namespace meander {

/// The file or folder whose name is nearest to one that does not exist, relative to `folder` as `path` is. Looks at
/// every part of the path for the nearest name in the folder reached so far, with and without ".lua".
std::optional<std::string> near_path(const std::string& path, const std::string& folder = {});

}  // namespace meander
