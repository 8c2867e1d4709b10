// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <string_view>

namespace meander {

/// The text for a message on a terminal that it must not be able to command: control characters and what is not UTF-8
/// as "\27", the way Lua writes them; line ends and tabs stay.
std::string visible_text(std::string_view text);

}  // namespace meander
