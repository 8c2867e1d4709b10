# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: the meander authors
# What `cmake --install` adds to the program and its module. Nothing installed knows the prefix: it may be moved.

# The worlds, models and examples are found from the program as share/meander; for the programs of a build tree that is the
# checkout.
file(MAKE_DIRECTORY "${PROJECT_BINARY_DIR}/share")
file(CREATE_LINK "${PROJECT_SOURCE_DIR}" "${PROJECT_BINARY_DIR}/share/meander" SYMBOLIC)
install(DIRECTORY examples worlds models DESTINATION share/meander)

file(GLOB pages CONFIGURE_DEPENDS docs/*.md)
install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES ${pages} DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs)
install(DIRECTORY docs/pictures DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs)

# complete(SHELL DESTINATION NAME): the program itself tells a shell what it takes, when it is installed.
function(complete shell destination name)
  set(file "${PROJECT_BINARY_DIR}/completions/${name}")
  file(MAKE_DIRECTORY "${PROJECT_BINARY_DIR}/completions")
  install(CODE "execute_process(COMMAND \"$<TARGET_FILE:meander>\" completion ${shell}
    OUTPUT_FILE \"${file}\" COMMAND_ERROR_IS_FATAL ANY)")
  install(FILES "${file}" DESTINATION ${destination})
endfunction()
complete(bash share/bash-completion/completions meander)
complete(zsh share/zsh/site-functions _meander)
complete(fish share/fish/vendor_completions.d meander.fish)

install(FILES docs/meander.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 OPTIONAL)

include(Package)
