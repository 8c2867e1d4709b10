# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: the meander authors
# CPack runs this over the installed tree before it is packed: what only a Debian package has.
if(NOT CPACK_GENERATOR STREQUAL "DEB")
  return()
endif()
set(share "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr/share")
set(doc "${share}/doc/meander")

# Debian's zsh looks elsewhere for what packages bring.
file(RENAME "${share}/zsh/site-functions" "${share}/zsh/vendor-completions")

file(WRITE "${doc}/copyright" "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: meander

Files: *
Copyright: 2026 the meander authors
License: GPL-3+
 This program is free software: you can redistribute it and/or modify it under
 the terms of the GNU General Public License as published by the Free Software
 Foundation, either version 3 of the License, or (at your option) any later
 version.
 .
 On Debian systems the full text of the GNU General Public License version 3 is
 in /usr/share/common-licenses/GPL-3.
")

# SOURCE_DATE_EPOCH, where it is set, makes the date the same in every build.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(changelog "${doc}/changelog.Debian")
file(WRITE "${changelog}" "meander (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium

  * Packaged by CPack from the source tree; changelog.gz tells what changed.

 -- ${CPACK_DEBIAN_PACKAGE_MAINTAINER}  ${date}
")
file(REMOVE "${doc}/LICENSE")
file(RENAME "${doc}/CHANGELOG.md" "${doc}/changelog")
file(GLOB pages "${share}/man/man1/*.1")
execute_process(COMMAND gzip -9nf "${doc}/changelog" "${changelog}" ${pages} COMMAND_ERROR_IS_FATAL ANY)

# The mask of whoever builds is nobody's business.
file(GLOB_RECURSE files LIST_DIRECTORIES true "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr/*")
foreach(file IN LISTS files)
  set(mode OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
  if(IS_DIRECTORY "${file}" OR file MATCHES "/usr/bin/")
    list(APPEND mode OWNER_EXECUTE GROUP_EXECUTE WORLD_EXECUTE)
  endif()
  file(CHMOD "${file}" PERMISSIONS ${mode})
endforeach()
