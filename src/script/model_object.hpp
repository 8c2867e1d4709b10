// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "mapping/sonar_network.hpp"
#include "script/kit_function.hpp"
#include "script/kit_object.hpp"
#include "script/kit_options.hpp"

namespace meander::script {

template <>
struct ObjectName<SonarModel> {
  static constexpr const char* value = "sonar_model";
};
template <>
struct ObjectName<SonarNetwork> {
  static constexpr const char* value = "sonar_network";
};
template <>
struct ObjectName<SonarLessons> {
  static constexpr const char* value = "lessons";
};
inline std::size_t native_size(const SonarModel& model) { return sizeof(SonarModel) + model.bytes; }
inline std::size_t native_size(const SonarNetwork& network) {
  return sizeof(SonarNetwork) + network.network.weights.size() * sizeof(float);
}
inline std::size_t native_size(const SonarLessons& lessons) {
  return sizeof(SonarLessons) + lessons.ranges.size() * sizeof(double) +
         lessons.cells.size() * sizeof(SonarLessons::Cell);
}

/// A sensor model: a name, a model, a network, or a Lua function.
struct ModelOption {
  std::function<SonarModel(const SonarModelOptions&)> make;
};
template <>
struct Lua<ModelOption> {
  static ModelOption read(lua_State* L, int index, const Path& path);
  static std::string type() { return "name, sonar_model, sonar_network or function(ranges, range, bearing)"; }
};
template <>
struct Describe<ModelOption> {
  static void into(OptionDoc& doc) { doc.values = sonar_model_names(); }
};

}  // namespace meander::script
