// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/bind.hpp"
#include "script/control_options.hpp"
#include "script/example_text.hpp"
#include "script/file_access.hpp"
#include "script/kit_type.hpp"
#include "script/numbers.hpp"
#include "script/picture.hpp"
#include "script/run_trace.hpp"
#include "study/run_file.hpp"

namespace meander::script {
namespace {

using RunPtr = std::shared_ptr<RunRecord>;

/// A member of Run as a property.
template <auto Member>
auto get(const RunRecord& record) {
  return record.run.*Member;
}
std::string hash(const RunRecord& record) { return fmt::format("{:016x}", record.run.hash); }
std::shared_ptr<World> world(const RunRecord& record) { return std::make_shared<World>(*record.world); }
int steps(const RunRecord& record) { return static_cast<int>(record.run.steps.size()); }

Numbers trace(const RunPtr& record, TraceName name) { return trace_of(record, name); }
Matrix sonar(const RunRecord& record) { return sonar_of(record.run); }
std::string to_json(const RunRecord& record) { return summary_json(record.run); }

void save(const RunRecord& record, const OutputFile& file) {
  const std::string& path = file.path;
  if (path.ends_with(".csv"))
    save_csv(record.run, path);
  else if (path.ends_with(".jsonl"))
    save_jsonl(record.run, path);
  else
    save_drawing(path, picture_of(record.run, *record.world), ".svg, .png, .csv or .jsonl");
}
DrawList picture(const RunRecord& record) { return picture_of(record.run, *record.world); }

std::string text(const RunRecord& record) {
  const Run& run = record.run;
  const std::string subgoals =
      run.subgoals > 0 ? fmt::format("{}/{}", run.reached, run.subgoals) : fmt::format("{}", run.reached);
  return fmt::format(
      "run: {} subgoals, {:.1f} m in {:.1f} s, {} contact{}, clearance min {:.2f} m, seed {}, hash {:016x}{}", subgoals,
      run.length, run.time, run.contacts, run.contacts == 1 ? "" : "s", run.clearance_min, run.seed, run.hash,
      run.reached < run.subgoals ? "; ended: " + run.reason : "");
}

void bind_outcome(Type<RunRecord>& type) {
  type.property<&get<&Run::reached>>(
          PropertyDoc{.name = "reached", .text = "Subgoals reached.", .example = EXAMPLE_RUN "print(run.reached)"})
      .property<&get<&Run::subgoals>>(PropertyDoc{
          .name = "subgoals", .text = "Subgoals in all; 0: unknown.", .example = EXAMPLE_RUN "print(run.subgoals)"})
      .property<&get<&Run::success>>(PropertyDoc{.name = "success",
                                                 .text = "Did the guide finish and say that the task is done?",
                                                 .example = EXAMPLE_RUN "print(run.success)"})
      .property<&get<&Run::reason>>(
          PropertyDoc{.name = "reason", .text = "Why it ended, in words.", .example = EXAMPLE_RUN "print(run.reason)"})
      .property<&get<&Run::contacts>>(PropertyDoc{
          .name = "contacts", .text = "How often it touched something.", .example = EXAMPLE_RUN "print(run.contacts)"})
      .property<&get<&Run::fault_contacts>>(PropertyDoc{.name = "fault_contacts",
                                                        .text = "Contacts by its own motion.",
                                                        .example = EXAMPLE_RUN "print(run.fault_contacts)"})
      .property<&get<&Run::trapped>>(PropertyDoc{.name = "trapped",
                                                 .text = "How often the navigator said that it is trapped.",
                                                 .example = EXAMPLE_RUN "print(run.trapped)"})
      .property<&get<&Run::seed>>(
          PropertyDoc{.name = "seed", .text = "Seed of the simulation.", .example = EXAMPLE_RUN "print(run.seed)"})
      .property<&hash>(PropertyDoc{.name = "hash",
                                   .text = "Hash of every state of the run, 16 hexadecimal digits.",
                                   .example = EXAMPLE_RUN "print(run.hash)"})
      .property<&get<&Run::navigator>>(
          PropertyDoc{.name = "navigator", .text = "Who drove.", .example = EXAMPLE_RUN "print(run.navigator)"})
      .property<&get<&Run::guide>>(
          PropertyDoc{.name = "guide", .text = "Who said where to.", .example = EXAMPLE_RUN "print(run.guide)"})
      .property<&get<&Run::goals>>(PropertyDoc{.name = "goals",
                                               .text = "The subgoals in the order they were given.",
                                               .unit = "m",
                                               .example = EXAMPLE_RUN "print(run.goals[1].x)"})
      .property<&world>(PropertyDoc{.name = "world",
                                    .text = "A copy of the world as it was at the end.",
                                    .example = EXAMPLE_RUN "print(run.world)"});
}

void bind_measures(Type<RunRecord>& type) {
  type
      .property<&get<&Run::time>>(PropertyDoc{
          .name = "time", .text = "How long it took.", .unit = "s", .example = EXAMPLE_RUN "print(run.time)"})
      .property<&get<&Run::length>>(PropertyDoc{
          .name = "length", .text = "The true way.", .unit = "m", .example = EXAMPLE_RUN "print(run.length)"})
      .property<&get<&Run::clearance_min>>(PropertyDoc{.name = "clearance_min",
                                                       .text = "Least distance from the hull to an obstacle.",
                                                       .unit = "m",
                                                       .example = EXAMPLE_RUN "print(run.clearance_min)"})
      .property<&get<&Run::clearance_mean>>(PropertyDoc{.name = "clearance_mean",
                                                        .text = "Mean distance from the hull to the nearest obstacle.",
                                                        .unit = "m",
                                                        .example = EXAMPLE_RUN "print(run.clearance_mean)"})
      .property<&get<&Run::turning>>(PropertyDoc{.name = "turning",
                                                 .text = "Sum of all changes of heading.",
                                                 .unit = "rad",
                                                 .example = EXAMPLE_RUN "print(run.turning)"})
      .property<&get<&Run::jerk>>(PropertyDoc{.name = "jerk",
                                              .text = "Mean change of acceleration; small is smooth.",
                                              .unit = "m/s^3",
                                              .example = EXAMPLE_RUN "print(run.jerk)"})
      .property<&get<&Run::cpu_per_cycle>>(PropertyDoc{.name = "cpu_per_cycle",
                                                       .text = "Computing time of guide and navigator per cycle.",
                                                       .unit = "s",
                                                       .example = EXAMPLE_RUN "print(run.cpu_per_cycle < 1)"})
      .property<&get<&Run::cycles>>(
          PropertyDoc{.name = "cycles", .text = "Control cycles.", .example = EXAMPLE_RUN "print(run.cycles)"})
      .property<&steps>(PropertyDoc{.name = "steps",
                                    .text = "Recorded cycles: the length of its traces.",
                                    .example = EXAMPLE_RUN "print(run.steps)"});
}

}  // namespace

void bind_run(lua_State* L) {
  Type<RunRecord> type(L, "How a drive went: figures, traces, a picture.");
  type.method<&trace>(Doc{.name = "trace",
                          .text = "A figure over all recorded cycles.",
                          .args = {{"name", "which"}},
                          .returns = "the numbers",
                          .errors = "unknown name",
                          .example = EXAMPLE_RUN "print(run:trace('clearance'):min())"})
      .method<&sonar>(Doc{.name = "sonar",
                          .text = "The sonar readings of all recorded cycles.",
                          .returns = "matrix, one row per cycle [m]",
                          .example = EXAMPLE_RUN "print(run:sonar()[1]:min())"})
      .method<&to_json>(Doc{.name = "to_json",
                            .text = "Its figures as one line of JSON.",
                            .returns = "JSON text",
                            .example = EXAMPLE_RUN "print(run:to_json())"})
      .method<&save>(Doc{.name = "save",
                         .text = "Writes a picture (.svg, .png), a table (.csv) or the record (.jsonl).",
                         .args = {{"path", "the suffix says what is written"}},
                         .errors = "unknown suffix; the file cannot be written",
                         .example = EXAMPLE_RUN "run:save(os.tmpname() .. '.csv')"})
      .text<&text>()
      .picture<&picture>();
  bind_outcome(type);
  bind_measures(type);
}

}  // namespace meander::script
