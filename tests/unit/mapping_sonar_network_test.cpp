// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <gtest/gtest.h>

#include <cmath>

#include "base/random.hpp"
#include "mapping/network_file.hpp"

namespace meander {
namespace {

const RingLayout kRing{16, 0.23, 0};

SonarNetwork random_sonar_network(const std::string& name, std::uint64_t seed, const RingLayout& ring = kRing) {
  SonarNetwork made{.name = name, .ring = ring, .features = sonar_features(name), .network = {}, .provenance = {}};
  made.network = random_network({made.features.inputs(), 7, 5, 1}, seed);
  made.provenance = {"ideal", "a test"};
  return made;
}

/// The inputs of [CN] 2.1 and 3.2 in plain words.
std::vector<double> plain_features(const std::string& name, const RingLayout& ring, const std::vector<double>& ranges,
                                   double range_max, double cell_range, double bearing) {
  const SonarFeatures f = sonar_features(name);
  std::vector<std::pair<double, int>> by_angle;
  for (int i = 0; i < ring.count; ++i)
    by_angle.emplace_back(std::abs(wrap_angle(bearing - (ring.first + 2 * kPi * i / ring.count))), i);
  std::sort(by_angle.begin(), by_angle.end());
  std::vector<double> readings, inputs;
  for (int k = 0; k < f.sonars; ++k) {
    const double range = ranges[static_cast<std::size_t>(by_angle[static_cast<std::size_t>(k)].second)];
    readings.push_back(range >= range_max ? f.range_cap : std::min(range + ring.radius, f.range_cap));
  }
  for (const double reading : readings) inputs.push_back(2 * reading / f.range_cap - 1);
  inputs.push_back(2 * cell_range / f.reach - 1);
  if (f.bearing) inputs.push_back(4 * by_angle[0].first / (2 * kPi / ring.count) - 1);
  if (f.residual)
    for (const double reading : readings) inputs.push_back(std::tanh((reading - cell_range) / f.residual_scale));
  return inputs;
}

std::vector<double> random_ranges(Stream& random, int count) {
  std::vector<double> ranges(static_cast<std::size_t>(count));
  for (double& range : ranges) range = random.chance(0.1) ? 6.477 : random.uniform(0.15, 4);
  return ranges;
}

TEST(SonarFeatures, AreThoseOfThePaperForAnyRing) {
  Stream random(1, "features");
  for (int trial = 0; trial < 2000; ++trial) {
    const RingLayout ring{3 + random.below(30), random.uniform(0.1, 0.5), random.uniform(-3, 3)};
    SonarLessons lessons{.ring = ring, .range_max = 6.477, .ranges = random_ranges(random, ring.count), .cells = {}};
    const double range = random.uniform(0.1, 2.2), bearing = random.uniform(-2 * kPi, 2 * kPi);
    lessons.cells.push_back({0, static_cast<float>(range), static_cast<float>(bearing), CellTruth::free});
    for (const std::string& name : sonar_network_names()) {
      const Examples examples = examples_of(lessons, sonar_features(name));
      const std::vector<double> plain = plain_features(name, ring, lessons.ranges, 6.477, range, bearing);
      ASSERT_EQ(examples.rows.size(), plain.size());
      for (std::size_t i = 0; i < plain.size(); ++i) ASSERT_NEAR(examples.rows[i], plain[i], 2e-4) << name << " " << i;
    }
  }
}

TEST(SonarNetworks, AModelGivesWhatTheNetworkGives) {
  Stream random(2, "model");
  for (const std::string& name : sonar_network_names()) {
    SonarNetwork network = random_sonar_network(name, 5);
    network.prior = -0.7;
    SonarLessons lessons{.ring = kRing, .range_max = 6.477, .ranges = random_ranges(random, 16), .cells = {}};
    std::vector<float> range, bearing;
    for (int i = 0; i < 333; ++i) {  // no multiple of any block
      range.push_back(static_cast<float>(random.uniform(0, 2.2)));
      bearing.push_back(static_cast<float>(random.uniform(-6, 6)));
      lessons.cells.push_back({0, range.back(), bearing.back(), CellTruth::free});
    }
    const std::vector<float> outputs = network_outputs(network.network, examples_of(lessons, network.features));
    std::vector<float> log_odds(range.size());
    const SonarModel model = network_model(network);
    model.evaluate({lessons.ranges, 6.477}, {range, bearing}, log_odds);
    for (std::size_t i = 0; i < outputs.size(); ++i) ASSERT_EQ(log_odds[i], outputs[i] + 0.7F) << name;
    range.assign(range.size(), 2.3F);  // beyond its reach
    model.evaluate({lessons.ranges, 6.477}, {range, bearing}, log_odds);
    for (const float value : log_odds) ASSERT_EQ(value, 0);
  }
}

TEST(SonarNetworks, TablesFollowSmoothNetworks) {
  Stream random(3, "table");
  for (const std::string& name : sonar_network_names()) {
    SonarNetwork network = random_sonar_network(name, 6);
    for (float& weight : network.network.weights) weight *= 0.5F;
    const SonarModel exact = network_model(network), table = table_model(network);
    double worst = 0, sum = 0;
    std::vector<float> range(61), bearing(61), a(61), b(61);
    for (int trial = 0; trial < 20; ++trial) {
      const std::vector<double> ranges = random_ranges(random, 16);
      for (std::size_t i = 0; i < range.size(); ++i) {
        range[i] = static_cast<float>(random.uniform(0, 2.4));
        bearing[i] = static_cast<float>(random.uniform(-6, 6));
      }
      exact.evaluate({ranges, 6.477}, {range, bearing}, a);
      table.evaluate({ranges, 6.477}, {range, bearing}, b);
      for (std::size_t i = 0; i < a.size(); ++i) {
        worst = std::max(worst, static_cast<double>(std::abs(a[i] - b[i])));
        sum += std::abs(a[i] - b[i]);
      }
    }
    EXPECT_LT(sum / (20 * 61), 0.06) << name;
    EXPECT_LT(worst, 0.6) << name;
  }
}

TEST(SonarNetworks, ExtremesAreTaken) {
  const SonarNetwork network = random_sonar_network("nn5", 1);
  for (const SonarModel& model : {network_model(network), table_model(network)}) {
    for (const double value : {0.0, -1.0, 1e300, std::nan(""), HUGE_VAL}) {
      const std::vector<double> ranges(16, value);
      const float range[] = {0, 1e30F, 2.2F, 1}, bearing[] = {1e30F, -1e30F, 0, std::nanf("")};
      float log_odds[4];
      model.evaluate({ranges, 6.477}, {range, bearing}, log_odds);
      for (const float told : log_odds) EXPECT_TRUE(std::isfinite(told));
    }
    EXPECT_THROW(model.evaluate({std::vector<double>(15, 1.0), 6.477}, {}, {}), ArgumentError);
  }
}

TEST(SonarNetworks, TellNothingOfWhatIsOutOfHearing) {
  const SonarNetwork network = random_sonar_network("nn4", 1);
  for (const SonarModel& model : {network_model(network), table_model(network)}) {
    const std::vector<double> silence(16, 1.2);
    const float range[] = {0.5F, 1.42F, 1.44F, 2.1F}, bearing[] = {0.1F, 0.1F, 0.1F, 0.1F};
    float short_sonar[4], long_sonar[4];
    model.evaluate({silence, 1.2}, {range, bearing}, short_sonar);
    model.evaluate({std::vector<double>(16, 6.477), 6.477}, {range, bearing}, long_sonar);
    for (const int heard : {0, 1}) EXPECT_EQ(short_sonar[heard], long_sonar[heard]) << "no echo";
    for (const int unheard : {2, 3}) EXPECT_EQ(short_sonar[unheard], 0);
    EXPECT_NE(long_sonar[3], 0);
  }
}

std::string problem_of(const std::string& text) {
  try {
    network_from_text(text, "w.txt");
  } catch (const FileError& error) {
    return error.what();
  }
  return "none";
}

std::string with(std::string text, const std::string& what, const std::string& other) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), other);
}

TEST(NetworkFile, ComesBackToTheBit) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    SonarNetwork network = random_sonar_network("nn3", seed, {24, 0.19, -0.125});
    network.prior = -1.0 / 3;
    const std::string text = network_text(network);
    const SonarNetwork again = network_from_text(text, "w.txt");
    EXPECT_EQ(again.network.weights, network.network.weights);
    EXPECT_EQ(again.features, network.features);
    EXPECT_EQ(again.prior, network.prior);
    EXPECT_EQ(again.provenance.made_by, "a test");
    EXPECT_EQ(network_text(again), text);
  }
}

TEST(NetworkFile, EachFaultHasItsMessage) {
  const std::string good = network_text(random_sonar_network("nn4", 1));
  EXPECT_EQ(problem_of(good), "none");
  EXPECT_NE(problem_of("").find("w.txt:1: the file is cut short"), std::string::npos);
  for (std::size_t length = 0; length < good.size(); length += 7)
    EXPECT_NE(problem_of(good.substr(0, length)), "none") << length;
  EXPECT_NE(problem_of(good.substr(0, good.size() / 2)).find("cut short"), std::string::npos);
  EXPECT_NE(problem_of(with(good, "network 1", "network 2")).find("no sonar network of this version"),
            std::string::npos);
  const std::string weights = good.substr(good.find("prior 0\n") + 8, 6);
  EXPECT_NE(problem_of(with(good, "prior 0\n" + weights, "prior 0\nnan ")).find("finite number"), std::string::npos);
  EXPECT_NE(problem_of(with(good, "layers 5", "layers 4")).find("another architecture"), std::string::npos);
  EXPECT_NE(problem_of(with(good, "layers 5 7", "layers 5 900000000")).find("units in a layer"), std::string::npos);
  EXPECT_NE(problem_of(with(good, "ring 16", "ring 99999")).find("ring.count"), std::string::npos);
  EXPECT_NE(problem_of(with(good, "a test", "a tent")).find("damaged"), std::string::npos);
  EXPECT_NE(problem_of(good + "x\n").find("after the checksum"), std::string::npos);
}

TEST(NetworkFile, WordsThatCouldNotBeReadBackAreRefused) {
  for (const char* words : {"two\nlines", "two\rlines", "a bell\a", "\x1b[2J", "half a \xc3", "del\x7f"}) {
    SonarNetwork network = random_sonar_network("nn1", 1);
    network.provenance.made_by = words;
    EXPECT_THROW(network_text(network), ArgumentError) << words;
    network = random_sonar_network("nn1", 1);
    network.name = words;
    EXPECT_THROW(network_text(network), ArgumentError) << words;
  }
  SonarNetwork network = random_sonar_network("nn1", 1);
  network.provenance = {"", "  \xc3\xa9 \"quoted\"\tand indented "};
  const SonarNetwork again = network_from_text(network_text(network), "w.txt");
  EXPECT_EQ(again.provenance.sonar, "");
  EXPECT_EQ(again.provenance.made_by, network.provenance.made_by);
  try {
    check_words("option 'made_by'", "two\nlines \x1b[2J");
    FAIL();
  } catch (const ArgumentError& error) {
    EXPECT_STREQ(error.what(),
                 "option 'made_by': one line without control characters expected, got 'two\\10lines \\27[2J'");
  }
  const std::string text = network_text(network);
  EXPECT_NE(problem_of(with(text, "quoted", "\x1b[2J")).find("w.txt:6: made_by: one line"), std::string::npos);
}

TEST(ShippedNetworks, AreThereForBothSonarsAndOneRing) {
  for (const std::string& name : sonar_network_names())
    for (const char* preset : {"ideal", "real"}) {
      const SonarNetwork network =
          read_network(std::string(MEANDER_SOURCE_DIR) + "/models/" + name + "_" + preset + ".txt");
      EXPECT_EQ(network.name, name);
      EXPECT_EQ(network.features, sonar_features(name));
      EXPECT_EQ(network.provenance.sonar, preset);
      EXPECT_NE(network.provenance.made_by.find("examples/train_sonar_model.lua"), std::string::npos);
      EXPECT_NO_THROW(check_ring("network", network.ring, platform("nomad200").sonar));
      EXPECT_THROW(check_ring("network", network.ring, platform("scout").sonar), ArgumentError);
    }
}

TEST(SonarModels, UnknownNamesAreToldTheKnownOnes) {
  try {
    sonar_model("nn44");
    FAIL();
  } catch (const ArgumentError& error) {
    EXPECT_STREQ(error.what(),
                 "unknown sonar model 'nn44'; known: nn1, nn2, nn3, nn4, nn5, elfes, ros; did you mean 'nn4'?");
  }
  EXPECT_THROW(sonar_model("nn4", {.ring = kRing, .preset = "../models/nn4"}), ArgumentError);
  EXPECT_THROW(sonar_model("nn4", {.ring = {12, 0.2, 0}}), ArgumentError);
}

TEST(SonarModels, TakeTheirOwnOptionsByName) {
  SonarModelOptions options{.ring = kRing};
  options.elfes.trust = 1;
  options.ros.reliable = 1.5;
  EXPECT_DOUBLE_EQ(sonar_model("elfes", options).reach, 1.23);
  EXPECT_DOUBLE_EQ(sonar_model("ros", options).reach, 3.73);
}

}  // namespace
}  // namespace meander
