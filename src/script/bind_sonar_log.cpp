// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/bind.hpp"
#include "script/file_access.hpp"
#include "script/kit_call.hpp"
#include "script/kit_module.hpp"
#include "script/kit_options.hpp"
#include "script/kit_type.hpp"
#include "script/objects.hpp"
#include "study/sonar_log.hpp"

/// A log `l` of two scans of four sonars, written to a file first.
#define EXAMPLE_LOG                                                                                                   \
  "f = io.open('log.csv', 'w') f:write('time,x,y,heading,s1,s2,s3,s4\\n0,0,0,0,1,2,1,2\\n1,0.1,0,0,0.9,2,1.1,2\\n') " \
  "f:close() l = meander.study.sonar_log 'log.csv' "

namespace meander {

template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, SonarLogReport>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"lines", "", "of the file"}, o.lines);
  visit(Field{"scans", "", "taken"}, o.scans);
  visit(Field{"short_records", "", "columns missing, too many, or no numbers: left out"}, o.short_records);
  visit(Field{"out_of_order", "", "times that do not fit between the others: left out"}, o.out_of_order);
  visit(Field{"bad_ranges", "", "impossible ranges: taken as no echo"}, o.bad_ranges);
  visit(Field{"without_pose", "", "scans before the first pose: left out"}, o.without_pose);
  visit(Field{"other", "", "records of kinds that are not read"}, o.other);
}

inline std::size_t native_size(const SonarLog& log) {
  return sizeof(SonarLog) +
         log.scans.size() * (sizeof(Observation) + static_cast<std::size_t>(log.sonars) * (sizeof(Pose2) + 8));
}

}  // namespace meander

namespace meander::script {

template <>
struct ObjectName<SonarLog> {
  static constexpr const char* value = "sonar_log";
};

namespace {

SonarLog read(const InputFile& file, const std::optional<SonarLogOptions>& options, const Call& call) {
  return read_sonar_log(file.path, options.value_or(SonarLogOptions{}), call.work());
}

int length(const SonarLog& log) { return static_cast<int>(log.scans.size()); }
std::optional<Observation> scan(const SonarLog& log, lua_Integer i) {
  if (i < 1 || i > length(log)) return std::nullopt;
  return log.scans[static_cast<std::size_t>(i - 1)];
}
SonarLogReport report(const SonarLog& log) { return log.report; }
std::optional<RingLayout> ring(const SonarLog& log) { return log.ring; }
std::string text(const SonarLog& log) {
  const SonarLogReport& r = log.report;
  const int left_out = r.short_records + r.out_of_order + r.without_pose;
  return fmt::format("sonar log: {} scans of {} sonars; {} records left out, {} impossible ranges", r.scans, log.sonars,
                     left_out, r.bad_ranges);
}

}  // namespace

void bind_sonar_log(lua_State* L) {
  Module(L, "meander.study", "")
      .function<&read>(Doc{
          .name = "sonar_log",
          .text = "Reads recorded scans with poses: a table (.csv, such as run:save writes; with contacts and light "
                  "where it has them) or a log of CARMEN (.log, .clf, .carmen).",
          .args = {{"path", "a file with the suffix .csv, .log, .clf or .carmen"},
                   {"options", "what becomes of records that cannot be right"}},
          .returns = "the log: log[i] is an observation, #log their number",
          .errors = "a file that is no log; with bad = 'refuse' the first record that cannot be right",
          .example = EXAMPLE_LOG "print(l, l[2].pose)"});
  Type<SonarLog>(L, "Recorded scans of a robot: log[i] is an observation, #log their number.")
      .property<&report>(PropertyDoc{.name = "report",
                                     .text = "What was met in the file: table of counts.",
                                     .example = EXAMPLE_LOG "print(l.report.bad_ranges)"})
      .property<&ring>(PropertyDoc{.name = "ring",
                                   .text = "Where the sonars sit, as the option sonar of a robot; nil when the file "
                                           "does not tell.",
                                   .unit = "m, rad",
                                   .example = EXAMPLE_LOG "print(l.ring)"})
      .property<&SonarLog::sonars>(
          PropertyDoc{.name = "sonars", .text = "Ranges in a scan.", .example = EXAMPLE_LOG "print(l.sonars)"})
      .length<&length>()
      .element<&scan>()
      .text<&text>();
}

}  // namespace meander::script
