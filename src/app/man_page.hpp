// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>

#include "script/docs.hpp"

namespace meander {

/// The manual page meander(1) in roff's man macros.
std::string man_page(const script::Docs& docs);

}  // namespace meander
