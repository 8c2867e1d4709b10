// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/cell_planner.hpp"
#include "script/bind.hpp"
#include "script/indicator_objects.hpp"
#include "script/kit_module.hpp"
#include "script/kit_type.hpp"
#include "script/objects.hpp"
#include "script/picture.hpp"
#include "world/generate_labyrinth.hpp"

namespace meander {

std::size_t native_size(const Labyrinth& labyrinth) {
  return sizeof(Labyrinth) + static_cast<std::size_t>(labyrinth.columns() * labyrinth.rows());
}
std::size_t native_size(const CellPlanner& planner) { return planner.bytes(); }

}  // namespace meander

namespace meander::script {

template <>
struct ObjectName<CellPlanner> {
  static constexpr const char* value = "cell_planner";
};

enum class Side { east, north, west, south };

}  // namespace meander::script

namespace meander {
template <>
struct EnumNames<script::Side> {
  static constexpr std::pair<script::Side, const char*> entries[] = {{script::Side::east, "east"},
                                                                     {script::Side::north, "north"},
                                                                     {script::Side::west, "west"},
                                                                     {script::Side::south, "south"}};
};
}  // namespace meander

namespace meander::script {

struct LabyrinthTable {
  LabyrinthPlan plan;
  std::optional<int> size;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, LabyrinthTable>
void fields(Options& o, Visitor&& visit) {
  fields(o.plan, visit);
  visit(Field{"size", "", "columns and rows at once, 1 to 200"}, o.size);
}

struct LabyrinthWorldTable {
  LabyrinthTable cells;
  LabyrinthWalls walls;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, LabyrinthWorldTable>
void fields(Options& o, Visitor&& visit) {
  fields(o.cells, visit);
  fields(o.walls, visit);
}

struct WallsTable {
  LabyrinthWalls walls;
  std::uint64_t seed = 1;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, WallsTable>
void fields(Options& o, Visitor&& visit) {
  fields(o.walls, visit);
  visit(Field{"seed", "", "of the jitter"}, o.seed);
}

struct CellWalkTable {
  Ending ending = Ending::driving;
  std::string reason;
  double length = 0;
  int decisions = 0;
  double coverage = 0;
  Vec2 last{0, 0};
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, CellWalkTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"ending", "", "how the run ended"}, o.ending);
  visit(Field{"reason", "", "in words"}, o.reason);
  visit(Field{"length", "m", "walked, cells have a side of 1 m"}, o.length);
  visit(Field{"decisions", "", "taken"}, o.decisions);
  visit(Field{"coverage", "", "share of the cells in reach that it was on"}, o.coverage);
  visit(Field{"last", "m", "where it ended"}, o.last);
}

namespace {

LabyrinthPlan plan_of(const LabyrinthTable& table) {
  LabyrinthPlan plan = table.plan;
  if (table.size) plan.columns = plan.rows = *table.size;
  return plan;
}

std::shared_ptr<Labyrinth> make(const LabyrinthTable& table) {
  return std::make_shared<Labyrinth>(make_labyrinth(plan_of(table)));
}
std::shared_ptr<World> make_world(const LabyrinthWorldTable& table) {
  const LabyrinthPlan plan = plan_of(table.cells);
  return std::make_shared<World>(labyrinth_world(make_labyrinth(plan), table.walls, plan.seed));
}

Cell cell_of(const Labyrinth& labyrinth, int column, int row) {
  const Cell cell{column - 1, row - 1};
  if (!labyrinth.contains(cell))
    fail("cell: a column from 1 to {} and a row from 1 to {} expected, got {} and {}", labyrinth.columns(),
         labyrinth.rows(), column, row);
  return cell;
}
Cell cell_at(const Labyrinth& labyrinth, const Vec2& at) {
  if (!(at.x() >= 0 && at.y() >= 0 && at.x() < labyrinth.columns() && at.y() < labyrinth.rows()))
    fail("start: a position in the labyrinth expected, got ({}, {})", at.x(), at.y());
  return {static_cast<int>(at.x()), static_cast<int>(at.y())};
}

bool is_open(const Labyrinth& labyrinth, int column, int row, Side side) {
  return labyrinth.open(cell_of(labyrinth, column, row), static_cast<int>(side));
}
void set_open(Labyrinth& labyrinth, int column, int row, Side side, bool open) {
  labyrinth.set_open(cell_of(labyrinth, column, row), static_cast<int>(side), open);
}
CellWalkTable told(const Labyrinth& labyrinth, Cell from, const CellWalk& walk) {
  return {walk.ending,           walk.reason, walk.walked, walk.decisions, coverage(labyrinth, from, walk),
          cell_center(walk.last)};
}
CellWalkTable explore(const Labyrinth& labyrinth, Explorer& explorer, const std::optional<Vec2>& start,
                      const Call& call) {
  const InUse in_use(call.L, &explorer, "explorer");
  const Cell from = start ? cell_at(labyrinth, *start) : Cell{0, 0};
  return told(labyrinth, from, walk_cells(labyrinth, from, explorer, call.work()));
}
std::optional<double> shortest(const Labyrinth& labyrinth, const std::optional<Vec2>& from,
                               const std::optional<Vec2>& to) {
  const Cell last{labyrinth.columns() - 1, labyrinth.rows() - 1};
  const double way =
      shortest_way(labyrinth, from ? cell_at(labyrinth, *from) : Cell{0, 0}, to ? cell_at(labyrinth, *to) : last);
  return way < 0 ? std::nullopt : std::optional(way);
}
std::shared_ptr<World> world(const Labyrinth& labyrinth, const WallsTable& table) {
  return std::make_shared<World>(labyrinth_world(labyrinth, table.walls, table.seed));
}
Vec2 goal(const Labyrinth& labyrinth) { return cell_center({labyrinth.columns() - 1, labyrinth.rows() - 1}); }
Vec2 start(const Labyrinth&) { return cell_center({0, 0}); }
std::shared_ptr<CellPlanner> planner(const Labyrinth& labyrinth, const std::optional<Vec2>& to) {
  const Cell last{labyrinth.columns() - 1, labyrinth.rows() - 1};
  return std::make_shared<CellPlanner>(labyrinth.columns(), labyrinth.rows(), to ? cell_at(labyrinth, *to) : last);
}
CellWalkTable walk(CellPlanner& planner, const Labyrinth& labyrinth, const std::optional<Vec2>& start,
                   const Call& call) {
  const Cell from = start ? cell_at(labyrinth, *start) : Cell{0, 0};
  return told(labyrinth, from, planner.walk(labyrinth, from, call.work()));
}
std::string planner_text(const CellPlanner& planner) {
  return planner.proven() ? "cell_planner: the shortest way is known" : "cell_planner";
}
DrawList picture(const Labyrinth& labyrinth) { return picture_of(labyrinth_world(labyrinth, {}, 1)); }
std::string text(const Labyrinth& labyrinth) {
  return fmt::format("labyrinth: {} x {} cells", labyrinth.columns(), labyrinth.rows());
}

#define LABYRINTH "l = meander.indicator.labyrinth { size = 6, seed = 2, loops = 0.1 } "

constexpr Arg kColumn{"column", "of the cell, 1 first"};
constexpr Arg kRow{"row", "of the cell, 1 first"};
constexpr Arg kSide{"side", "which"};

void bind_cells(lua_State* L) {
  Type<Labyrinth>(L, "Cells of 1 m with or without walls between them.")
      .method<&explore>(
          Doc{.name = "explore",
              .text = "A run of an explorer by a robot that recognises every crossing, follows corridors by itself and "
                      "knows where it is.",
              .args = {{"explorer", "who decides"}, {"start", "a point in the cell; the first one when left out", "m"}},
              .returns = "ending, reason, length, decisions, coverage, last",
              .errors = "a start outside",
              .example = LABYRINTH "print(l:explore(meander.indicator.explorer { goal = l.goal }).reason)"})
      .method<&planner>(
          Doc{.name = "planner",
              .text = "What explorers are compared with that keeps a map of cells: always the shortest way as if all "
                      "were open that was not seen closed, kept up by D* Lite.",
              .args = {{"to", "a point in a cell, the goal; the last one when left out", "m"}},
              .returns = "the planner, which knows nothing yet",
              .errors = "a point outside",
              .example = LABYRINTH "print(l:planner():walk(l).length, l:shortest())"})
      .method<&shortest>(Doc{.name = "shortest",
                             .text = "Length of the shortest way.",
                             .args = {{"from", "a point in a cell; the first one when left out", "m"},
                                      {"to", "a point in a cell; the last one when left out", "m"}},
                             .returns = "length [m]; nil: there is no way",
                             .errors = "a point outside",
                             .example = LABYRINTH "print(l:shortest())"})
      .method<&is_open>(Doc{.name = "open",
                            .text = "Is there a way out of a cell on a side?",
                            .args = {kColumn, kRow, kSide},
                            .returns = "boolean",
                            .errors = "no such cell",
                            .example = LABYRINTH "print(l:open(1, 1, 'east'))"})
      .method<&set_open>(Doc{.name = "set_open",
                             .text = "Takes a wall between two cells away, or puts it there.",
                             .args = {kColumn, kRow, kSide, {"open", "true: no wall"}},
                             .errors = "no such cell; a wall around the labyrinth",
                             .example = LABYRINTH "l:set_open(1, 1, 'east', true)"})
      .method<&world>(Doc{.name = "world",
                          .text = "The world with its walls.",
                          .args = {{"options", "width of the corridors, jitter"}},
                          .returns = "the world",
                          .errors = "a number out of range",
                          .example = LABYRINTH "show(l:world { corridor = 1.2 })"})
      .property<&Labyrinth::columns>(
          PropertyDoc{.name = "columns", .text = "Cells along x.", .example = LABYRINTH "print(l.columns)"})
      .property<&Labyrinth::rows>(
          PropertyDoc{.name = "rows", .text = "Cells along y.", .example = LABYRINTH "print(l.rows)"})
      .property<&start>(PropertyDoc{
          .name = "start", .text = "Centre of the first cell.", .unit = "m", .example = LABYRINTH "print(l.start.x)"})
      .property<&goal>(PropertyDoc{
          .name = "goal", .text = "Centre of the last cell.", .unit = "m", .example = LABYRINTH "print(l.goal.x)"})
      .picture<&picture>()
      .text<&text>();
}

void bind_planner(lua_State* L) {
  Type<CellPlanner>(L, "Keeps to the shortest way over cells by all that it has seen of them.")
      .method<&walk>(
          Doc{.name = "walk",
              .text = "A run by a robot that sees which sides of its cell are open and how far, and knows where it is.",
              .args = {{"labyrinth", "one of the size that it was made for"},
                       {"start", "a point in the cell; the first one when left out", "m"}},
              .returns = "ending, reason, length, decisions, coverage, last",
              .errors = "another size; a start outside",
              .example = LABYRINTH "p = l:planner() p:walk(l) print(p:walk(l).length)"})
      .property<&CellPlanner::proven>(PropertyDoc{.name = "proven",
                                                  .text = "The last run was as short as it can be.",
                                                  .example = LABYRINTH "print(l:planner().proven)"})
      .text<&planner_text>();
}

}  // namespace

void bind_labyrinth(lua_State* L) {
  Module(L, "meander.world", "")
      .function<&make_world>(Doc{
          .name = "labyrinth",
          .text = "Makes the world of a labyrinth from a seed: corridors between thin walls, or crooked ones.",
          .args = {{"options", "the labyrinth and its walls"}},
          .returns = "the world, with a start in the first cell and the place 'goal' in the last",
          .errors = "a number out of range",
          .example = "w = meander.world.labyrinth { kind = 'prim', size = 8, loops = 0.1, corridor = 1.2 } show(w)"});
  Module(L, "meander.indicator", "")
      .function<&make>(Doc{
          .name = "labyrinth",
          .text = "The cells of a labyrinth, on which rules can be tried without sensors and driving.",
          .args = {{"options", "kind, size, loops, rooms, seed"}},
          .returns = "the labyrinth",
          .errors = "a number out of range",
          .example = LABYRINTH "print(l:explore(meander.indicator.explorer { goal = l.goal }).length, l:shortest())"});
  bind_cells(L);
  bind_planner(L);
}

}  // namespace meander::script
