# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: the meander authors
# What `cmake --install` adds to the program and its module. Nothing installed knows the prefix: it may be moved.

# The worlds and examples are found from the program as share/meander, in a build tree as well.
set(data_folders examples worlds)
file(MAKE_DIRECTORY "${PROJECT_BINARY_DIR}/share/meander")
foreach(folder IN LISTS data_folders)
  file(CREATE_LINK "${PROJECT_SOURCE_DIR}/${folder}" "${PROJECT_BINARY_DIR}/share/meander/${folder}" SYMBOLIC)
endforeach()
install(DIRECTORY ${data_folders} DESTINATION share/meander)

file(GLOB pages CONFIGURE_DEPENDS docs/*.md)
install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES ${pages} DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs)
install(DIRECTORY docs/pictures DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs)

# The program tells the shells what it takes.
set(completions "${PROJECT_BINARY_DIR}/completions")
set(completion_files "")
foreach(shell bash zsh fish)
  add_custom_command(OUTPUT "${completions}/${shell}"
    COMMAND ${CMAKE_COMMAND} -E make_directory "${completions}"
    COMMAND meander completion ${shell} > "${completions}/${shell}"
    DEPENDS meander VERBATIM)
  list(APPEND completion_files "${completions}/${shell}")
endforeach()
add_custom_target(completions ALL DEPENDS ${completion_files})
install(FILES "${completions}/bash" DESTINATION share/bash-completion/completions RENAME meander)
install(FILES "${completions}/zsh" DESTINATION share/zsh/site-functions RENAME _meander)
install(FILES "${completions}/fish" DESTINATION share/fish/vendor_completions.d RENAME meander.fish)

install(FILES docs/meander.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 OPTIONAL)

include(Package)
