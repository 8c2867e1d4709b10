// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <algorithm>
#include <cctype>
#include <set>

#include "base/error.hpp"
#include "base/names.hpp"
#include "base/text_file.hpp"
#include "world/text.hpp"
#include "world/toml_depth.hpp"
#include "world/toml_table.hpp"
#include "world/validity.hpp"
#include "world/world_file.hpp"

namespace meander {
namespace {

using Keys = std::vector<std::string>;
constexpr std::size_t kLongestComplaint = 200;

/// A shape is told by one key that only it has.
struct ShapeForm {
  const char* noun;
  const char* sign;
  Keys keys;
  Shape (*read)(const TomlTable&);
};

const std::vector<ShapeForm>& shape_forms() {
  static const std::vector<ShapeForm> forms{
      {"a wall",
       "points",
       {"points", "closed"},
       [](const TomlTable& t) -> Shape {
         return Chain{t.points("points"), t.flag("closed", false)};
       }},
      {"a polygon",
       "outer",
       {"outer", "holes"},
       [](const TomlTable& t) -> Shape {
         return Polygon{t.points("outer"), t.point_lists("holes")};
       }},
      {"a box",
       "size",
       {"center", "size", "heading"},
       [](const TomlTable& t) -> Shape {
         return Rectangle{t.pair("center"), t.pair("size", "[width, height]"), t.number("heading", 0)};
       }},
      {"a disc",
       "radius",
       {"center", "radius"},
       [](const TomlTable& t) -> Shape {
         return Disc{t.pair("center"), t.number("radius")};
       }},
      {"a door leaf",
       "from",
       {"from", "to"},
       [](const TomlTable& t) -> Shape {
         return Chain{{t.pair("from"), t.pair("to")}, false};
       }},
  };
  return forms;
}

Keys shape_keys(bool door) {
  Keys keys;
  for (const ShapeForm& form : shape_forms())
    if (door || form.sign != std::string("from"))
      for (const std::string& key : form.keys)
        if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
  return keys;
}

Keys joined(Keys keys, const Keys& more) {
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

Shape read_shape(const TomlTable& table, bool door) {
  for (const ShapeForm& form : shape_forms()) {
    if (!table.has(form.sign)) continue;
    for (const std::string& key : shape_keys(true))
      if (table.has(key.c_str()) && std::find(form.keys.begin(), form.keys.end(), key) == form.keys.end())
        table.refuse(
            fmt::format("key '{}' does not go with '{}': {} has {}", key, form.sign, form.noun, listing(form.keys)),
            key.c_str());
    return form.read(table);
  }
  table.refuse(
      fmt::format("the shape is missing: {}points (wall), outer (polygon), center and size (box) or center and "
                  "radius (disc) expected",
                  door ? "from and to, " : ""));
}

Surface read_surface(const TomlTable& table) {
  return {table.number("echo", Surface{}.echo), table.optional_number("specular_limit")};
}

Motion read_motion(const TomlTable& table) {
  const std::string name = table.text("motion", to_string(Mover{}.motion));
  if (const auto motion = enum_from<Motion>(name)) return *motion;
  const auto known = enum_names<Motion>();
  table.refuse(
      fmt::format("key 'motion': unknown value '{}', one of {}{}", name, listing(known), did_you_mean(name, known)),
      "motion");
}

/// How a table of one kind becomes a thing; in the order of Item.
struct Kind {
  const char* name;
  Keys keys;
  Item (*read)(const TomlTable&, const std::string& name);
};

const std::vector<Kind>& kinds() {
  static const Keys surface{"echo", "specular_limit"};
  static const std::vector<Kind> all{
      {"obstacle", joined(joined({"name"}, shape_keys(false)), surface),
       [](const TomlTable& t, const std::string& name) -> Item {
         return Obstacle{name, read_shape(t, false), read_surface(t)};
       }},
      {"door", joined(joined({"name"}, shape_keys(true)), joined({"open"}, surface)),
       [](const TomlTable& t, const std::string& name) -> Item {
         return Door{name, read_shape(t, true), t.flag("open", Door{}.open), read_surface(t)};
       }},
      {"mover",
       {"name", "center", "radius", "motion", "waypoints", "speed", "yields"},
       [](const TomlTable& t, const std::string& name) -> Item {
         const auto waypoints = t.has("waypoints") ? t.points("waypoints") : std::vector<Vec2>{};
         return Mover{name,      {t.pair("center"), t.number("radius")}, read_motion(t),
                      waypoints, t.number("speed", Mover{}.speed),       t.flag("yields", Mover{}.yields)};
       }},
      {"light",
       {"name", "position", "strength"},
       [](const TomlTable& t, const std::string& name) -> Item {
         return Light{name, t.pair("position"), t.number("strength", Light{}.strength)};
       }},
      {"place",
       {"name", "position", "heading", "tolerance"},
       [](const TomlTable& t, const std::string& name) -> Item {
         return Place{name, t.pair("position"), t.optional_number("heading"), t.number("tolerance", Place{}.tolerance)};
       }},
  };
  return all;
}

Header read_header(const TomlTable& table) {
  table.check_keys({"format", "title", "note", "bounds", "start"});
  if (const auto format = table.integer("format"); format != kWorldFormat)
    table.refuse(fmt::format("key 'format': {} expected, got {}", kWorldFormat, format), "format");
  Header header{table.text("title", ""), table.text("note", ""), {}, {}};
  std::erase(header.note, '\r');
  const auto corners = table.points("bounds");
  if (corners.size() != 2) table.refuse("key 'bounds': [[low x, low y], [high x, high y]] expected", "bounds");
  header.bounds = {corners[0], corners[1]};
  if (table.has("start")) header.start = table.pose("start");
  return header;
}

/// One table of a thing, in the order of the file.
struct Entry {
  toml::source_position position;
  const Kind* kind;
  const toml::table* table;
};

class WorldReader {
 public:
  WorldReader(const toml::table& root, const std::string& path, const Work& work)
      : root_(root), path_(path), work_(work) {}

  World read() {
    check_top_level();
    collect();
    const auto* header = root_["world"].as_table();
    if (!header) fail<FileError>("{}: the table [world] with format = {} is missing", path_, kWorldFormat);
    const TomlTable table(*header, path_, "[world]");
    World world;
    Header beginning = read_header(table);
    try {
      world = World(std::move(beginning));
    } catch (const ArgumentError& error) {
      table.refuse(error.what());
    }
    for (const Entry& entry : entries_) {
      work_.poll();
      add(world, entry);
    }
    world.forget_history();
    return world;
  }

 private:
  void check_top_level() const {
    Keys known{"world"};
    for (const Kind& kind : kinds()) known.emplace_back(kind.name);
    TomlTable(root_, path_, "").check_keys(known);
  }

  void collect() {
    for (const Kind& kind : kinds()) {
      const toml::node* node = root_.get(kind.name);
      if (!node) continue;
      const auto* list = node->as_array();
      if (!list || !std::all_of(list->begin(), list->end(), [](const toml::node& n) { return n.is_table(); }))
        fail<FileError>("{}:{}: [[{}]] with double brackets expected, got {}", path_, node->source().begin.line,
                        kind.name, describe(*node));
      for (const toml::node& element : *list) {
        entries_.push_back({element.source().begin, &kind, element.as_table()});
        if (const auto* name = element.as_table()->get_as<std::string>("name")) taken_.insert(name->get());
      }
    }
    std::stable_sort(entries_.begin(), entries_.end(),
                     [](const Entry& a, const Entry& b) { return a.position < b.position; });
  }

  /// Things without a name get "kind number", where no other thing of the file has that name.
  std::string name_of_entry(const Entry& entry, std::size_t number) {
    if (entry.table->contains("name"))
      return TomlTable(*entry.table, path_, fmt::format("[[{}]]", entry.kind->name)).text("name", "");
    std::string name;
    do name = fmt::format("{} {}", entry.kind->name, number++);
    while (!taken_.insert(name).second);
    return name;
  }

  void add(World& world, const Entry& entry) {
    const std::string name = name_of_entry(entry, world.size() + 1);
    const TomlTable table(*entry.table, path_, fmt::format("[[{}]] '{}'", entry.kind->name, printable(name)));
    table.check_keys(entry.kind->keys);
    if (name.empty()) table.refuse("key 'name': 1 to 64 characters expected, got none", "name");
    Item item = entry.kind->read(table, name);
    const std::string thing = label(item);
    try {
      world.add(std::move(item));
    } catch (const ArgumentError& error) {
      const std::string reason = error.what();
      if (reason.starts_with(thing)) table.refuse_plainly(reason);
      table.refuse(reason);
    }
  }

  const toml::table& root_;
  const std::string& path_;
  const Work& work_;
  std::vector<Entry> entries_;
  std::set<std::string> taken_;
};

}  // namespace

World read_world(const std::string& path, const Work& work) {
  return world_from_toml(read_text_file(path, kLargestWorldFile), path, work);
}

World world_from_toml(const std::string& text, const std::string& path, const Work& work) {
  check_key_depth(text, path);
  toml::table root;
  try {
    root = toml::parse(text, path);
  } catch (const toml::parse_error& error) {
    // It quotes what it met, which may be a line break.
    std::string what = printable(error.description(), kLongestComplaint);
    if (!what.empty()) what[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(what[0])));
    fail<FileError>("{}:{}:{}: {}", path, error.source().begin.line, error.source().begin.column, what);
  }
  return WorldReader(root, path, work).read();
}

}  // namespace meander
