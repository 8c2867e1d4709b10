// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/folder.hpp"
#include "script/bind.hpp"
#include "script/kit_function.hpp"
#include "script/kit_module.hpp"

namespace meander::script {

void bind_folder(lua_State* L) {
  Module(L, "meander", "A laboratory for sonar navigation.")
      .function<&make_folder>(Doc{.name = "make_folder",
                                  .text = "Makes a folder, and those above it, where they are missing.",
                                  .args = {{"path", "the folder"}},
                                  .errors = "a file is in the way; no permission",
                                  .example = "meander.make_folder(os.tmpname():match('^(.*)/'))"});
}

}  // namespace meander::script
