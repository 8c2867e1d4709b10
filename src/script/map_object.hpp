// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "mapping/sonar_map.hpp"
#include "script/model_object.hpp"

namespace meander::script {

template <>
struct ObjectName<SonarMap> {
  static constexpr const char* value = "map";
};
inline std::size_t native_size(const SonarMap& map) { return sizeof(SonarMap) + map.bytes(); }

/// Which sensor model a map has.
struct MapChoice {
  std::optional<ModelOption> what;
  SonarModelOptions options;

  SonarModel model(const Platform& platform) const {
    SonarModelOptions made_for = options;
    made_for.ring = platform.sonar;
    return what ? what->make(made_for) : sonar_model("nn4", made_for);
  }
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, MapChoice>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"model", "",
              "what scans tell about cells: a name that meander.mapping.models() tells, 'nn4' when left out; a "
              "model, a network, or a function as meander.mapping.model takes it"},
        o.what);
  fields(o.options, visit);
}

}  // namespace meander::script
