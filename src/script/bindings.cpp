// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/bindings.hpp"

#include "script/bind.hpp"
#include "script/lua_setup.hpp"

namespace meander::script {

void bind_all(lua_State* L) {
  open_output(L);
  bind_folder(L);
  bind_world(L);
  bind_world_edit(L);
  bind_world_module(L);
  bind_world_generate(L);
  bind_thing(L);
  bind_numbers(L);
  bind_matrix(L);
  bind_observation(L);
  bind_navigators(L);
  bind_baselines(L);
  bind_polar(L);
  bind_sim(L);
  bind_drive(L);
  bind_watch(L);
  bind_render(L);
  bind_run(L);
  bind_robot(L);
  bind_sensor(L);
  bind_study(L);
  bind_mapping_map(L);
  bind_mapping_model(L);
  bind_mapping_train(L);
  bind_map_score(L);
  bind_map_navigators(L);
  bind_sonar_log(L);
  bind_planning_map(L);
  bind_plan(L);
  bind_replanner(L);
  bind_planned_route(L);
  bind_indicator(L);
  bind_explorer(L);
  bind_sonar_explorer(L);
  bind_shortest_path(L);
  bind_labyrinth(L);
  bind_topology(L);
  bind_topology_drive(L);
  bind_minimal_map(L);
  bind_place_scores(L);
  bind_words(L);
  bind_help(L);
}

}  // namespace meander::script
