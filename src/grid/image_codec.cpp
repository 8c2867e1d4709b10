// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "grid/image_codec.hpp"

#include <dlfcn.h>

#include <filesystem>

#include "base/data_folder.hpp"
#include "base/error.hpp"

namespace meander {
namespace {

const Codec* load() {
  std::string tried;
  for (const std::string& path : beside_program("lib/meander/codecs.so")) {
    std::error_code failed;
    if (!std::filesystem::exists(path, failed)) {
      tried += (tried.empty() ? "" : ", ") + path;
      continue;
    }
    void* module = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!module) fail<FileError>("{}: the image codecs cannot be loaded: {}", path, ::dlerror());
    const auto entry = reinterpret_cast<const Codec* (*)()>(::dlsym(module, kCodecSymbol));
    if (!entry) fail<FileError>("{}: not the image codecs of this program", path);
    return entry();
  }
  fail<FileError>("the image codecs are missing: no {}", tried);
}

}  // namespace

const Codec& image_codec() {
  static const Codec* codec = load();
  return *codec;
}

}  // namespace meander
