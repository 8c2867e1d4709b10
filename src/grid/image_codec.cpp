// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "grid/image_codec.hpp"

#include <dlfcn.h>

#include <filesystem>

#include "base/error.hpp"

namespace meander {
namespace {

/// lib/meander/codecs.so in the folder of the running program and in the two above it: PREFIX/bin/meander and every
/// program of a build tree find their own.
std::vector<std::string> candidates() {
  std::error_code failed;
  std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", failed).parent_path();
  std::vector<std::string> paths;
  for (int level = 0; level < 3 && !folder.empty(); ++level, folder = folder.parent_path())
    paths.push_back((folder / "lib" / "meander" / "codecs.so").string());
  return paths;
}

const Codec* load() {
  std::string tried;
  for (const std::string& path : candidates()) {
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
