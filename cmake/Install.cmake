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
