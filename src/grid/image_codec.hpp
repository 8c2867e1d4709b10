// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "grid/codec/codec.hpp"

namespace meander {

/// The codec module, loaded at the first call. Throws FileError that names the places where it was looked for.
const Codec& image_codec();

}  // namespace meander
