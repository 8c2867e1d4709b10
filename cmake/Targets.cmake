# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: the meander authors
# meander_flags(TARGET): one set of compiler flags for every target of the project.
function(meander_flags target)
  get_target_property(type ${target} TYPE)
  set(scope PRIVATE)
  if(type STREQUAL INTERFACE_LIBRARY)
    return()
  endif()
  # Same bits in every build: no fused multiply-add unless written, never -ffast-math.
  target_compile_options(${target} ${scope} -ffp-contract=off -Wall -Wextra $<$<CXX_COMPILER_ID:GNU>:-Wshadow=local> -Wnon-virtual-dtor -Wpedantic)
  if(MEANDER_WERROR)
    target_compile_options(${target} ${scope} -Werror)
  endif()
  if(MEANDER_SANITIZE)
    # The three left out are seen by AddressSanitizer where the pointer is used; without them the kernels compile twice
    # as fast.
    target_compile_options(${target} ${scope} -fsanitize=address,undefined
      -fno-sanitize=null,pointer-overflow,object-size -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} ${scope} -fsanitize=address,undefined)
  endif()
endfunction()

# meander_folder(NAME USES folder... PRIVATE_USES target... PUBLIC_USES target...)
# One target per folder of src/. USES names the folders it may include: the table of docs/architecture.md, held by
# the link list here and by tests/arch. Folders without .cpp files become header-only targets.
function(meander_folder name)
  cmake_parse_arguments(arg "" "" "USES;PRIVATE_USES;PUBLIC_USES" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(TRANSFORM arg_USES PREPEND meander_)
  if(sources)
    add_library(meander_${name} STATIC ${sources})
    target_include_directories(meander_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
    target_link_libraries(meander_${name} PUBLIC ${arg_USES} ${arg_PUBLIC_USES} PRIVATE ${arg_PRIVATE_USES})
    set_target_properties(meander_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    meander_flags(meander_${name})
  else()
    add_library(meander_${name} INTERFACE)
    target_include_directories(meander_${name} INTERFACE ${PROJECT_SOURCE_DIR}/src)
    target_link_libraries(meander_${name} INTERFACE ${arg_USES} ${arg_PUBLIC_USES})
  endif()
endfunction()
