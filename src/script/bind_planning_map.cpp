// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "grid/movingai.hpp"
#include "render/draw_plan.hpp"
#include "script/bind.hpp"
#include "script/file_access.hpp"
#include "script/kit_module.hpp"
#include "script/kit_type.hpp"
#include "script/picture.hpp"
#include "script/planning_objects.hpp"
#include "world/rasterize.hpp"

/// A map `m` of 8 x 4 cells of a metre, and a wall in it.
#define EXAMPLE_GRID \
  "m = meander.planning.map { world = meander.world.new { bounds = {{0, 0}, {8, 4}} }, resolution = 1 } "

namespace meander::script {

struct ScenarioView {
  Vec2 start{0, 0}, goal{0, 0};
  double length = 0;
  int bucket = 0;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, ScenarioView>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"start", "m", "centre of the cell"}, o.start);
  visit(Field{"goal", "m", "centre of the cell"}, o.goal);
  visit(Field{"length", "cells", "of the shortest way, as published"}, o.length);
  visit(Field{"bucket", "", "a quarter of the length"}, o.bucket);
}

namespace {

PlanningMap from_cells(const MapSourceTable& table) {
  const Matrix& rows = table.cells->matrix;
  Grid<float> grid(static_cast<int>(rows.columns), static_cast<int>(rows.rows), 0,
                   {table.resolution, {table.origin.x(), table.origin.y(), 0}});
  grid.cells().assign(rows.cells->begin(), rows.cells->begin() + static_cast<std::ptrdiff_t>(grid.cells().size()));
  return map_from_occupancy(grid, table.occupancy);
}

PlanningMap from_sonar_map(const MapSourceTable& table) {
  const SonarMap& map = *table.sonar_map;
  return map_from_occupancy(map.probabilities(map.global() ? MapPart::global : MapPart::local), table.occupancy);
}

}  // namespace

std::shared_ptr<const PlanningMap> map_of(const MapSourceTable& table, const Work& work) {
  const int named = (table.map ? 1 : 0) + (table.world ? 1 : 0) + (table.sonar_map ? 1 : 0) + (table.cells ? 1 : 0);
  if (named != 1) fail("one of the options 'map', 'world', 'sonar_map' and 'cells' expected, got {}", named);
  if (table.map) return table.map;
  if (table.world)
    return std::make_shared<PlanningMap>(
        PlanningMap{.solid = rasterize(*table.world, table.resolution, table.world->header().bounds, work)});
  return std::make_shared<PlanningMap>(table.cells ? from_cells(table) : from_sonar_map(table));
}

namespace {

std::shared_ptr<PlanningMap> make(const MapSourceTable& table, const Call& call) {
  return std::make_shared<PlanningMap>(*map_of(table, call.work()));
}
std::shared_ptr<PlanningMap> read_map(const InputFile& file, const std::optional<double>& resolution) {
  if (resolution && !(*resolution >= 1e-3 && *resolution <= 1e3))
    fail("resolution: a number from 0.001 to 1000 [m] expected, got {}", *resolution);
  MovingAiMap map = read_movingai_map(file.path);
  map.blocked.frame.resolution = resolution.value_or(1);
  return std::make_shared<PlanningMap>(PlanningMap{.solid = std::move(map.blocked)});
}

std::vector<ScenarioView> scenarios(const PlanningMap& map, const InputFile& file) {
  std::vector<ScenarioView> views;
  for (const MovingAiScenario& s : read_movingai_scenarios(file.path, map.solid.width(), map.solid.height()))
    views.push_back({map.solid.frame.center(s.start), map.solid.frame.center(s.goal), s.length, s.bucket});
  return views;
}

void block(PlanningMap& map, const Box& box, const std::optional<bool>& solid) {
  set_solid(map, box, solid.value_or(true));
}
bool solid(const PlanningMap& map, double x, double y) { return map.solid.at(map.solid.frame.cell({x, y}), 1) != 0; }
int width(const PlanningMap& map) { return map.solid.width(); }
int height(const PlanningMap& map) { return map.solid.height(); }
double resolution(const PlanningMap& map) { return map.solid.frame.resolution; }
std::string text(const PlanningMap& map) {
  std::size_t solid = 0;
  for (const std::uint8_t cell : map.solid.cells()) solid += cell;
  return fmt::format("grid_map: {} x {} cells of {} m, {} solid", width(map), height(map), resolution(map), solid);
}
DrawList picture(const PlanningMap& map) { return draw_planning_map(map, theme(Background::light)); }

void bind_module(lua_State* L) {
  Module(L, "meander.planning", "Global planning on maps of cells: neural maps and their peers.")
      .function<&make>(Doc{.name = "map",
                           .text = "A map of cells to plan on. Edits of it do not change what it was made from.",
                           .args = {{"options", "what it is made from"}},
                           .returns = "the map",
                           .errors = "none or several sources; a number out of range",
                           .example = "print(meander.planning.map { cells = { {0, 0, 1}, {0, 0.5, 0} } })"})
      .function<&read_map>(
          Doc{.name = "read_map",
              .text = "Reads a map of movingai.com cell by cell.",
              .args = {{"path", "a .map file"}, {"resolution", "side of a cell; 1 when left out", "m"}},
              .returns = "the map",
              .errors = "no such file; what is wrong in it, with the line",
              .example = "f = os.tmpname() io.open(f, 'w'):write('type octile\\nheight 1\\nwidth "
                         "3\\nmap\\n.@.\\n'):close() print(meander.planning.read_map(f))"});
}

}  // namespace

void bind_planning_map(lua_State* L) {
  bind_module(L);
  Type<PlanningMap>(L, "A map of cells to plan on.")
      .method<&scenarios>(Doc{.name = "scenarios",
                              .text = "Reads the tasks that movingai.com publishes for this map.",
                              .args = {{"path", "a .scen file"}},
                              .returns = "list of tasks: start, goal, length, bucket",
                              .returns_type = "list of table",
                              .errors = "no such file; another map's size; what is wrong in it, with the line",
                              .example =
                                  EXAMPLE_GRID "f = os.tmpname() io.open(f, 'w'):write('version 1\\n0 x 8 4 0 0 3 0 "
                                               "3\\n'):close() print(m:scenarios(f)[1].length)"})
      .method<&block>(Doc{.name = "block",
                          .text = "Puts something solid over all cells whose centres lie in a box, or takes it away.",
                          .args = {{"box", "where", "m"}, {"solid", "false takes it away"}},
                          .example = EXAMPLE_GRID "m:block {{3, 0}, {4, 3}} print(m:solid(3.5, 1.5))"})
      .method<&set_difficulty>(
          Doc{.name = "set_difficulty",
              .text = "How hard it is to go through the cells of a box: cost of a way, for its length.",
              .args = {{"box", "where", "m"}, {"difficulty", "1 is usual; below 1: preferred"}},
              .errors = "a number that is not from 0.001 to 1000",
              .example = EXAMPLE_GRID "m:set_difficulty({{3, 0}, {4, 3}}, 5) print(m)"})
      .method<&set_drag>(
          Doc{.name = "set_drag",
              .text = "Inclines and preferred ways: a way in direction u costs 1 + drag . u times as much.",
              .args = {{"box", "where", "m"}, {"drag", "uphill; of length up to 0.999"}},
              .errors = "a longer vector",
              .example = EXAMPLE_GRID "m:set_drag({{3, 0}, {4, 3}}, {0.5, 0}) print(m)"})
      .method<&solid>(Doc{.name = "solid",
                          .text = "Does something solid stand there?",
                          .args = {{"x", "where", "m"}, {"y", "where", "m"}},
                          .returns = "true in solid cells and outside of the map",
                          .example = EXAMPLE_GRID "print(m:solid(3.5, 1.5))"})
      .property<&width>(
          PropertyDoc{.name = "width", .text = "Cells along x.", .example = EXAMPLE_GRID "print(m.width)"})
      .property<&height>(
          PropertyDoc{.name = "height", .text = "Cells along y.", .example = EXAMPLE_GRID "print(m.height)"})
      .property<&resolution>(PropertyDoc{
          .name = "resolution", .text = "Side of a cell.", .unit = "m", .example = EXAMPLE_GRID "print(m.resolution)"})
      .text<&text>()
      .picture<&picture>();
}

}  // namespace meander::script
