// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/picture_file.hpp"

#include "base/atomic_file.hpp"
#include "render/svg.hpp"

namespace meander {

void save_picture(const std::string& path, const DrawList& list, const PictureSize& size) {
  if (path.ends_with(".svg"))
    write_file_atomically(path, svg(list));
  else if (path.ends_with(".png"))
    write_image(path, raster(list, size));
  else
    fail("picture: file name that ends in .svg or .png expected, got '{}'", path);
}

}  // namespace meander
