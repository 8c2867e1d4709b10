// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "study/run_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "autonomy/subgoal_list.hpp"
#include "sim_worlds.hpp"
#include "study/drive.hpp"

namespace meander {
namespace {

using Json = nlohmann::json;

Run example() {
  Sim sim(room(10, 6), {nomad(Pose2{1, 1, 0})}, {.seed = 18446744073709551615u});
  const Navigator ahead{.name = "ahead", .step = [](const Observation&, const Subgoal&) -> NavigatorStep {
                          return {{0.4, 0, 0}, NavigatorStatus::driving, {}};
                        }};
  return drive(sim, ahead,
               subgoal_list({{.position = {3, 1}, .tolerance = 0.2, .heading = 0.5, .name = "there \"x\""},
                             {.position = {4, 1}, .tolerance = 0.2, .heading = {}, .name = {}}}));
}

std::vector<std::string> lines_of(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

class RunFile : public testing::Test {
 protected:
  std::string path(const std::string& name) const {
    return (std::filesystem::path(testing::TempDir()) / ("meander_run_" + std::to_string(getpid()) + name)).string();
  }
};

TEST_F(RunFile, TheSummaryIsOneLineWithTheFixedKeys) {
  const auto run = example();
  const std::string text = summary_json(run);
  EXPECT_EQ(text.find('\n'), std::string::npos);
  const Json json = Json::parse(text);
  for (const char* key : {"seed", "reached", "subgoals", "contacts", "time", "length", "clearance_min", "hash"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_EQ(json["seed"], 18446744073709551615u);
  EXPECT_EQ(json["hash"], fmt::format("{:016x}", run.hash));
  EXPECT_EQ(json["length"].get<double>(), run.length);
}

TEST_F(RunFile, TheTraceHoldsHeadStepsAndFiguresExactly) {
  const auto run = example();
  save_jsonl(run, path(".jsonl"));
  const auto lines = lines_of(path(".jsonl"));
  ASSERT_EQ(lines.size(), run.steps.size() + 2);
  const Json head = Json::parse(lines.front());
  EXPECT_EQ(head["record"], "meander run");
  EXPECT_EQ(head["world"], fmt::format("{:016x}", run.world_hash));
  EXPECT_EQ(head["robot"]["platform"]["body"]["radius"], 0.2667);
  EXPECT_EQ(head["robot"]["sonar"]["firing"], "sequence");
  EXPECT_EQ(head["goals"][0]["name"], "there \"x\"");
  EXPECT_EQ(head["goals"][0]["heading"], 0.5);
  for (std::size_t i = 0; i < run.steps.size(); ++i) {
    const Json step = Json::parse(lines[i + 1]);
    EXPECT_EQ(step["t"].get<double>(), run.steps[i].time);
    EXPECT_EQ(step["pose"][0].get<double>(), run.steps[i].pose_world.x);
    EXPECT_EQ(step["clearance"].get<double>(), run.steps[i].clearance);
    EXPECT_EQ(step["sonar"].size(), 16u);
    EXPECT_EQ(step["sonar"][3].get<float>(), run.steps[i].sonar[3]);
  }
  EXPECT_EQ(lines.back(), summary_json(run));
  std::filesystem::remove(path(".jsonl"));
}

TEST_F(RunFile, TheTableHasAHeadAndOneRowPerStep) {
  const auto run = example();
  save_csv(run, path(".csv"));
  const auto lines = lines_of(path(".csv"));
  ASSERT_EQ(lines.size(), run.steps.size() + 1);
  const auto columns = std::count(lines[0].begin(), lines[0].end(), ',');
  EXPECT_EQ(columns, 13 + 16);
  for (const std::string& line : lines) EXPECT_EQ(std::count(line.begin(), line.end(), ','), columns);
  std::istringstream row(lines.back());
  double time = 0, x = 0;
  char comma = 0;
  row >> time >> comma >> x;
  EXPECT_DOUBLE_EQ(time, run.steps.back().time);
  EXPECT_DOUBLE_EQ(x, run.steps.back().pose_world.x);
  std::filesystem::remove(path(".csv"));
}

TEST_F(RunFile, ARunWithoutStepsAndStrangeTextsCanBeSaved) {
  auto run = example();
  run.steps.clear();
  run.reason = "broken \xff text";
  save_csv(run, path(".csv"));
  save_jsonl(run, path(".jsonl"));
  EXPECT_EQ(lines_of(path(".csv")).size(), 1u);
  EXPECT_TRUE(Json::accept(lines_of(path(".jsonl")).back()));
  std::filesystem::remove(path(".csv"));
  std::filesystem::remove(path(".jsonl"));
}

TEST_F(RunFile, AFolderThatIsNotThereIsAnErrorThatNamesThePath) {
  try {
    save_csv(example(), "/no/such/folder/run.csv");
    FAIL();
  } catch (const FileError& e) {
    EXPECT_NE(std::string(e.what()).find("/no/such/folder/run.csv"), std::string::npos);
  }
}

}  // namespace
}  // namespace meander
