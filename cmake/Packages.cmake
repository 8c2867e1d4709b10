# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: the meander authors
# Every outside library, found once, under one target name each.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(TBB REQUIRED)
find_package(CLI11 REQUIRED)
find_package(Boost 1.74 REQUIRED)
find_package(OpenCVSplit REQUIRED COMPONENTS core imgproc imgcodecs)
pkg_check_modules(tomlplusplus REQUIRED IMPORTED_TARGET tomlplusplus)
pkg_check_modules(readline REQUIRED IMPORTED_TARGET readline)
# The C++ build of Lua: only it runs destructors when an error passes through C++ frames.
pkg_check_modules(lua REQUIRED IMPORTED_TARGET lua5.4-c++)
