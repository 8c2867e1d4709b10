# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: the meander authors
# `cpack -G DEB` in the build folder makes meander_VERSION_ARCH.deb for the Debian it runs on; `cpack -G TGZ` an archive
# that runs where it is unpacked, if the libraries are there.
set(CPACK_PACKAGE_NAME meander)
set(CPACK_PACKAGE_VENDOR "the meander authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "laboratory for sonar navigation in a terminal")
set(CPACK_PACKAGE_DESCRIPTION
  "meander simulates mobile robots that see nothing but the echoes of their
sonars. Worlds are edited, robots driven and what they do measured from Lua:
at a prompt, in scripts and in tests.
.
The sonar model knows cones, incidence, reflections and crosstalk; the same
seed gives the same bits. Maps of ROS, floor plans and BARN worlds are
imported, pictures shown in the terminal or written as PNG and SVG.")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR TGZ)
if(EXISTS /etc/debian_version)
  set(CPACK_GENERATOR DEB)
endif()

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "The meander authors <authors@meander.invalid>")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "ffmpeg, man-db")
set(CPACK_PRE_BUILD_SCRIPTS "${PROJECT_SOURCE_DIR}/cmake/DebianLayout.cmake")
# To pack is not to build the tests.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
include(CPack)
