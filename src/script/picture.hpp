// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "render/draw_list.hpp"
#include "script/kit_call.hpp"
#include "world/world.hpp"

namespace meander::script {

DrawList picture_of(const World& world);

/// The picture as text for the terminal that the session writes to, as large as it is.
std::string terminal_picture(const DrawList& list, const Call& call);

/// Writes .svg or .png. Another suffix is an error that names `suffixes`, the ones that the caller takes.
void save_drawing(const std::string& path, const DrawList& list, const char* suffixes);

}  // namespace meander::script
