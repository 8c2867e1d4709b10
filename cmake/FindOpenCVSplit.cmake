# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: the meander authors
# Debian's split OpenCV packages (libopencv-core-dev, ...) ship neither OpenCVConfig.cmake nor opencv4.pc; only
# libopencv-dev does, and that one pulls Qt, GTK and VTK. Defines OpenCVSplit::<component> for each component asked for.
find_path(OpenCVSplit_INCLUDE_DIR opencv2/core.hpp PATH_SUFFIXES opencv4)
set(_required OpenCVSplit_INCLUDE_DIR)
foreach(_component IN LISTS OpenCVSplit_FIND_COMPONENTS)
  find_library(OpenCVSplit_${_component}_LIBRARY opencv_${_component})
  list(APPEND _required OpenCVSplit_${_component}_LIBRARY)
endforeach()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenCVSplit REQUIRED_VARS ${_required})
if(OpenCVSplit_FOUND)
  foreach(_component IN LISTS OpenCVSplit_FIND_COMPONENTS)
    if(NOT TARGET OpenCVSplit::${_component})
      add_library(OpenCVSplit::${_component} UNKNOWN IMPORTED)
      set_target_properties(OpenCVSplit::${_component} PROPERTIES
        IMPORTED_LOCATION "${OpenCVSplit_${_component}_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${OpenCVSplit_INCLUDE_DIR}"
        INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${OpenCVSplit_INCLUDE_DIR}")
    endif()
  endforeach()
endif()
