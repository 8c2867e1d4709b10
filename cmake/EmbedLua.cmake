# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: the meander authors
# meander_embed_lua(TARGET DIR): packs DIR/**/*.lua into TARGET as a C++ table of names and texts; DIR/a/b.lua becomes the
# module meander.a.b. DIR/meta holds annotations for editors, no code. Run as a script, this file writes that table.
if(CMAKE_SCRIPT_MODE_FILE)
  file(GLOB_RECURSE files RELATIVE "${DIR}" "${DIR}/*.lua")
  list(FILTER files EXCLUDE REGEX "^meta/")
  list(SORT files)
  set(rows "")
  foreach(file IN LISTS files)
    file(READ "${DIR}/${file}" text)
    string(REGEX REPLACE "\\.lua$" "" name "${file}")
    string(REPLACE "/" "." name "${name}")
    string(APPEND rows "    {\"meander.${name}\", R\"lua~(${text})lua~\"},\n")
  endforeach()
  file(WRITE "${OUTPUT}" "#include \"script/lua_embedded.hpp\"

namespace meander::script {

std::span<const EmbeddedModule> embedded_modules() {
  static constexpr EmbeddedModule modules[] = {
${rows}    {\"\", \"\"}};
  return std::span(modules).first(std::size(modules) - 1);
}

}  // namespace meander::script
")
  return()
endif()

set(MEANDER_EMBED_SCRIPT "${CMAKE_CURRENT_LIST_FILE}")
function(meander_embed_lua target dir)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS "${dir}/*.lua")
  set(output "${CMAKE_CURRENT_BINARY_DIR}/lua_embedded.cpp")
  add_custom_command(OUTPUT "${output}"
    COMMAND ${CMAKE_COMMAND} -DDIR=${dir} -DOUTPUT=${output} -P "${MEANDER_EMBED_SCRIPT}"
    DEPENDS ${files} "${MEANDER_EMBED_SCRIPT}" VERBATIM)
  target_sources(${target} PRIVATE "${output}")
endfunction()
