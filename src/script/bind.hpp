// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <lua.h>

namespace meander::script {

// One function per bind_<thing>.cpp; bind_all() calls them in an order in which every name that is used is there.
void bind_world(lua_State* L);
void bind_world_edit(lua_State* L);
void bind_world_module(lua_State* L);
void bind_world_generate(lua_State* L);
void bind_thing(lua_State* L);
void bind_numbers(lua_State* L);
void bind_matrix(lua_State* L);
void bind_observation(lua_State* L);
void bind_sim(lua_State* L);
void bind_drive(lua_State* L);
void bind_watch(lua_State* L);
void bind_render(lua_State* L);
void bind_run(lua_State* L);
void bind_robot(lua_State* L);
void bind_sensor(lua_State* L);
void bind_navigators(lua_State* L);
void bind_baselines(lua_State* L);
void bind_polar(lua_State* L);
void bind_study(lua_State* L);
void bind_planning_map(lua_State* L);
void bind_plan(lua_State* L);
void bind_replanner(lua_State* L);
void bind_planned_route(lua_State* L);
void bind_mapping_map(lua_State* L);
void bind_mapping_model(lua_State* L);
void bind_mapping_train(lua_State* L);
void bind_map_score(lua_State* L);
void bind_map_navigators(lua_State* L);
void bind_sonar_log(lua_State* L);
void bind_indicator(lua_State* L);
void bind_topology(lua_State* L);
void bind_topology_drive(lua_State* L);
void bind_minimal_map(lua_State* L);
void bind_place_scores(lua_State* L);
void bind_explorer(lua_State* L);
void bind_sonar_explorer(lua_State* L);
void bind_shortest_path(lua_State* L);
void bind_labyrinth(lua_State* L);
void bind_folder(lua_State* L);
void bind_words(lua_State* L);
void bind_help(lua_State* L);

}  // namespace meander::script
