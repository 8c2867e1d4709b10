// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

namespace meander::repl {

/// Opens a file in $VISUAL, else $EDITOR, else the first of editor, nano and vi there is, and waits for its end. The
/// keys that interrupt are the editor's until then, and the terminal is left as it was. Throws Error saying why the
/// editor did not do its work.
void edit_file(const std::string& path);

/// What the user makes of the text, without the line ends behind it, by way of a private file that is gone afterwards.
std::string edit_text(const std::string& text);

}  // namespace meander::repl
