// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "base/atomic_file.hpp"
#include "world/attributes.hpp"
#include "world/world_file.hpp"

namespace meander {
namespace {

/// A text of several lines as it reads, between triple quotes.
std::string lines_text(const std::string& text) {
  std::string result = "\"\"\"\n";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"\"\"";
}

void append(std::string& to, const Attributes& attributes) {
  for (const Attribute& attribute : attributes) {
    if (attribute.usual) continue;
    const auto* text = std::get_if<std::string>(&attribute.value);
    const bool several_lines = text && text->find('\n') != std::string::npos;
    to += attribute.key + std::string(" = ") +
          (several_lines ? lines_text(*text) : value_text(attribute.value, kToml)) + "\n";
  }
}

}  // namespace

std::string to_toml(const World& world) {
  std::string text = fmt::format("[world]\nformat = {}\n", kWorldFormat);
  append(text, attributes(world.header()));
  for (const Id id : world.ids()) {
    const Item& item = world.item(id);
    text += fmt::format("\n[[{}]]\n", kind_of(item));
    append(text, attributes(item));
  }
  return text;
}

void write_world(const std::string& path, const World& world) { write_file_atomically(path, to_toml(world)); }

}  // namespace meander
