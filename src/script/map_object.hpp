// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "mapping/classic_models.hpp"
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
  std::string preset = "ideal";
  bool table = false;
  ConeModelOptions elfes;
  RangeLayerOptions ros;

  SonarModel model(const Platform& platform) const {
    const SonarModelOptions options{.ring = platform.sonar, .preset = preset, .table = table};
    if (!what) return sonar_model("nn4", options);
    if (what->name == "elfes") return cone_model(platform.sonar, elfes);
    if (what->name == "ros") return range_layer_model(platform.sonar, ros);
    return what->make(options);
  }
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, MapChoice>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"model", "",
              "what scans tell about cells: a name that meander.mapping.models() tells, 'nn4' when left out; a "
              "model, a network, or a function as meander.mapping.model takes it"},
        o.what);
  visit(Field{"preset", "", "networks: sonar that their weights were trained for"}, o.preset);
  visit(Field{"table", "", "networks: compiled to a lookup table, faster and a little worse"}, o.table);
  visit(Field{"elfes", "", "options of the model of this name"}, o.elfes);
  visit(Field{"ros", "", "options of the model of this name"}, o.ros);
}

}  // namespace meander::script
