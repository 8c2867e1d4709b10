// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/data_folder.hpp"
#include "base/folder.hpp"
#include "script/bind.hpp"
#include "script/file_access.hpp"
#include "script/kit_function.hpp"
#include "script/kit_module.hpp"

namespace meander::script {
namespace {

void make(const OutputFile& folder) { make_folder(folder.path); }

std::optional<std::string> data() {
  const std::string folder = data_folder();
  return folder.empty() ? std::nullopt : std::optional(folder);
}

}  // namespace

void bind_folder(lua_State* L) {
  Module(L, "meander", "A laboratory for sonar navigation.")
      .function<&make>(Doc{.name = "make_folder",
                           .text = "Makes a folder, and those above it, where they are missing.",
                           .args = {{"path", "the folder"}},
                           .errors = "a file is in the way; no permission",
                           .example = "meander.make_folder(os.tmpname():match('^(.*)/'))"})
      .function<&data>(Doc{.name = "data_folder",
                           .text = "The folder of the worlds and examples that came with the program; files that are "
                                   "not found here are looked for there.",
                           .returns = "its path, nil when there is none",
                           .example = "print(meander.data_folder())"});
}

}  // namespace meander::script
