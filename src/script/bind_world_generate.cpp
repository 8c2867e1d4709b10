// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/bind.hpp"
#include "script/kit_module.hpp"
#include "script/objects.hpp"
#include "world/generate_clutter.hpp"

namespace meander::script {

enum class GeneratedKind { clutter };

}  // namespace meander::script

namespace meander {
template <>
struct EnumNames<script::GeneratedKind> {
  static constexpr std::pair<script::GeneratedKind, const char*> entries[] = {
      {script::GeneratedKind::clutter, "clutter"}};
};
}  // namespace meander

namespace meander::script {

struct GenerateTable {
  GeneratedKind kind = GeneratedKind::clutter;
  ClutterOptions clutter;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, GenerateTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"kind", "", "what kind of world"}, o.kind);
  fields(o.clutter, visit);
}

namespace {

std::tuple<std::shared_ptr<World>, std::optional<std::string>> generate(const GenerateTable& table, const Call& call) {
  const ClutterOptions& o = table.clutter;
  if (std::optional<World> world = generate_clutter(o, call.work()))
    return {std::make_shared<World>(std::move(*world)), std::nullopt};
  return {nullptr,
          fmt::format("seed {}: none of {} draws with a density of {:g} has a route with {:g} m on either side", o.seed,
                      o.draws, o.density, o.route)};
}

}  // namespace

void bind_world_generate(lua_State* L) {
  Module(L, "meander.world", "")
      .function<&generate>(Doc{.name = "generate",
                               .text = "Makes a world from a seed: clutter, boxes and discs strewn over a room.",
                               .args = {{"options", "what kind, the seed, how dense, how wide a route"}},
                               .returns = "the world; or nil and why when there is none",
                               .returns_type = "world or nil, string or nil",
                               .errors = "a number out of range",
                               .example = "w = meander.world.generate { kind = 'clutter', seed = 3, density = 0.08 }"});
}

}  // namespace meander::script
