// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/model_object.hpp"

#include <algorithm>

#include "script/values.hpp"

namespace meander::script {
namespace {

constexpr double kEverywhere = 1e6;  ///< reach of a model in Lua [m]

std::vector<double> listed(std::span<const float> values) { return {values.begin(), values.end()}; }

SonarModel lua_model(const Function& function, const SonarModelOptions& options) {
  const auto evaluate = [function](const SonarSweep& sweep, const CellPlaces& cells, std::span<float> log_odds) {
    const std::vector<double> ranges(sweep.ranges.begin(), sweep.ranges.end());
    const auto told = function.get<Values>(ranges, listed(cells.range), listed(cells.bearing));
    if (told.list.size() != cells.size())
      fail("{}: log-odds of {} cells expected, got {}", function.result_path().text(), cells.size(), told.list.size());
    std::transform(told.list.begin(), told.list.end(), log_odds.begin(),
                   [](double value) { return static_cast<float>(std::clamp(value, -1e6, 1e6)); });
  };
  return {.name = "lua", .ring = options.ring, .reach = kEverywhere, .evaluate = evaluate};
}

}  // namespace

ModelOption Lua<ModelOption>::read(lua_State* L, int index, const Path& path) {
  if (lua_isfunction(L, index))
    return {[function = Function(L, index, path)](const SonarModelOptions& options) {
      return lua_model(function, options);
    }};
  if (test_box(L, index, tag_of<SonarModel>))
    return {[model = read_object<SonarModel>(L, index, path)](const SonarModelOptions& options) {
      check_ring("model " + model->name, model->ring, options.ring);
      return *model;
    }};
  if (test_box(L, index, tag_of<SonarNetwork>))
    return {[network = read_object<SonarNetwork>(L, index, path)](const SonarModelOptions& options) {
      check_ring("network " + network->name, network->ring, options.ring);
      return options.table ? table_model(*network) : network_model(*network);
    }};
  if (lua_type(L, index) != LUA_TSTRING) expected(L, index, path, type());
  const std::string name = Lua<std::string>::read(L, index, path);
  return {[name](const SonarModelOptions& options) { return sonar_model(name, options); }};
}

}  // namespace meander::script
