// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "world/world_diff.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "world/attributes.hpp"
#include "world/validity.hpp"

namespace meander {
namespace {

const Dialect kWords{'(', ')', [](const std::string& text) { return "'" + text + "'"; }};

std::string in_words(const Attribute* attribute) {
  constexpr std::size_t kMostPoints = 6;
  if (!attribute) return "none";
  if (const auto* points = std::get_if<Points>(&attribute->value); points && points->size() > kMostPoints)
    return fmt::format("{} points", points->size());
  if (const auto* lists = std::get_if<std::vector<Points>>(&attribute->value))
    return fmt::format("{} list{} of points", lists->size(), lists->size() == 1 ? "" : "s");
  if (const auto* text = std::get_if<std::string>(&attribute->value); text && text->find('\n') != std::string::npos)
    return "a text of several lines";
  return value_text(attribute->value, kWords);
}

const Attribute* find(const Attributes& attributes, const char* key) {
  const auto found =
      std::find_if(attributes.begin(), attributes.end(), [&](const Attribute& a) { return std::string(a.key) == key; });
  return found == attributes.end() ? nullptr : &*found;
}

std::string change(const char* key, const Attribute* from, const Attribute* to) {
  const std::string a = in_words(from), b = in_words(to);
  return a == b ? fmt::format("{} differs", key) : fmt::format("{} {} -> {}", key, a, b);
}

/// "center (1, 2) -> (2, 2), heading 0 -> 0.5"; empty when nothing differs.
std::string changes(const Attributes& from, const Attributes& to) {
  std::vector<std::string> parts;
  for (const Attribute& a : from) {
    const Attribute* b = find(to, a.key);
    if (!b || !(*b == a)) parts.push_back(change(a.key, &a, b));
  }
  for (const Attribute& b : to)
    if (!find(from, b.key)) parts.push_back(change(b.key, nullptr, &b));
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// The names of `world` that `other` has too, for things of the same kind, in order.
std::vector<std::string> common_names(const World& world, const World& other) {
  std::vector<std::string> names = world.names();
  std::erase_if(names, [&](const std::string& name) {
    return !other.has(name) || other.item(other.find(name)).index() != world.item(world.find(name)).index();
  });
  return names;
}

}  // namespace

std::vector<std::string> difference(const World& a, const World& b) {
  std::vector<std::string> lines;
  if (auto text = changes(attributes(a.header()), attributes(b.header())); !text.empty())
    lines.push_back("world: " + text);
  const auto counterpart = [](const World& world, const Item& item) -> const Item* {
    if (!world.has(name_of(item))) return nullptr;
    const Item& other = world.item(world.find(name_of(item)));
    return other.index() == item.index() ? &other : nullptr;
  };
  for (const Id id : a.ids()) {
    const Item& item = a.item(id);
    const Item* other = counterpart(b, item);
    if (!other)
      lines.push_back("removed " + label(item));
    else if (auto text = changes(attributes(item), attributes(*other)); !text.empty())
      lines.push_back(label(item) + ": " + text);
  }
  for (const Id id : b.ids())
    if (!counterpart(a, b.item(id))) lines.push_back("added " + label(b.item(id)));
  const auto first = common_names(a, b), second = common_names(b, a);
  const auto [x, y] = std::mismatch(first.begin(), first.end(), second.begin());
  if (x != first.end()) lines.push_back(fmt::format("order: '{}' where '{}' was", *y, *x));
  return lines;
}

}  // namespace meander
