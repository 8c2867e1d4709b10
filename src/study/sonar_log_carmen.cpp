// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <algorithm>
#include <numeric>

#include "robot/kinematics.hpp"
#include "study/sonar_log_text.hpp"

namespace meander {
namespace {

constexpr int kMostSonars = 1024;
constexpr double kUneven = 0.09;  ///< sonars may be so far from even spacing [rad]

struct Odom {
  double time;
  Pose2 pose;
  std::size_t record;
};
struct Scan {
  double time;
  int line;
  std::vector<double> ranges;
  std::size_t record;
};

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(" \t"); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(" \t", end);
  }
  return words;
}

class CarmenReader {
 public:
  CarmenReader(const std::string& name, const SonarLogOptions& options)
      : name_(name), options_(options), bad_(name, options.bad) {}

  SonarLog read(std::string_view text, const Work& work) {
    LogLines lines(text, work);
    while (lines.next()) {
      if (lines.line().empty() || lines.line().front() == '#') continue;
      line_ = lines.number();
      words_ = words_of(lines.line());
      if (words_.empty()) continue;
      if (words_.front() == "ODOM")
        odom();
      else if (words_.front() == "SONAR")
        sonar();
      else
        ++log_.report.other;
    }
    log_.report.lines = lines.number();
    keep_in_order();
    if (!offsets_.empty()) order();
    pose_scans();
    log_.report.scans = static_cast<int>(log_.scans.size());
    return std::move(log_);
  }

 private:
  /// The numbers of the words from `first` on; nothing when there are too few or other things.
  std::optional<std::vector<double>> numbers(std::size_t first, std::size_t count) const {
    if (words_.size() < first + count) return std::nullopt;
    std::vector<double> numbers;
    for (std::size_t i = first; i < first + count; ++i) {
      const auto number = number_in(words_[i]);
      if (!number) return std::nullopt;
      numbers.push_back(*number);
    }
    return numbers;
  }
  /// ipc time, host and logger time end a record.
  std::optional<double> time_after(std::size_t end) const {
    if (words_.size() != end + 3) return std::nullopt;
    const auto time = number_in(words_.back());
    return time && std::abs(*time) < kNoTime ? time : std::nullopt;
  }
  /// The number of the record that is being read, among those with a time.
  std::size_t stamped(double time) {
    stamps_.push_back({time, line_});
    return stamps_.size() - 1;
  }
  void keep_in_order() {
    const std::vector<bool> keep = in_order(stamps_, bad_, log_.report);
    const auto late = [&](const auto& one) { return !keep[one.record]; };
    std::erase_if(odoms_, late);
    std::erase_if(scans_, late);
    for (Scan& scan : scans_)
      for (double& range : scan.ranges) range = checked_range(range, scan.line, options_, bad_, log_.report);
  }
  void short_record(const char* form) {
    bad_(log_.report.short_records, line_, fmt::format("'{}' expected, with numbers", form));
  }

  void odom() {
    const auto values = numbers(1, 6);
    const auto time = time_after(7);
    if (!values || !time ||
        !std::all_of(values->begin(), values->begin() + 3, [](double v) { return std::isfinite(v); }))
      return short_record("ODOM x y theta tv rv accel ipc_time host logger_time");
    odoms_.push_back({*time, {(*values)[0], (*values)[1], wrap_angle((*values)[2])}, stamped(*time)});
  }

  void sonar() {
    const auto head = numbers(1, 2);
    const double claimed = head ? (*head)[1] : 0;
    const int count = claimed >= 1 && claimed <= kMostSonars ? static_cast<int>(claimed) : 0;
    const auto n = static_cast<std::size_t>(count);
    const auto ranges = numbers(3, n), offsets = numbers(3 + n, 3 * n);
    const auto time = time_after(3 + 4 * n);
    if (count == 0 || !ranges || !offsets || !time || (log_.sonars && log_.sonars != count))
      return short_record("SONAR cone count ranges... x y theta... ipc_time host logger_time");
    if (!log_.sonars) offsets_ = *offsets;
    log_.sonars = count;
    scans_.push_back({*time, line_, *ranges, stamped(*time)});
  }

  /// Ring order: forward first, counter-clockwise, evenly spaced on a circle; no map reads another.
  void order() {
    const auto n = static_cast<std::size_t>(log_.sonars);
    const double pitch = 2 * kPi / static_cast<double>(n);
    std::vector<std::size_t> by_angle(n);
    std::iota(by_angle.begin(), by_angle.end(), 0);
    const auto bearing = [&](std::size_t i) {
      const double theta = wrap_angle(offsets_[3 * i + 2]);
      return theta < -0.5 * pitch ? theta + 2 * kPi : theta;
    };
    if (!std::all_of(offsets_.begin(), offsets_.end(), [](double v) { return std::isfinite(v); }))
      fail<FileError>("{}: the sonars' offsets are no numbers", name_);
    std::stable_sort(by_angle.begin(), by_angle.end(), [&](auto a, auto b) { return bearing(a) < bearing(b); });
    RingLayout ring{static_cast<int>(n), 0, bearing(by_angle[0])};
    for (std::size_t k = 0; k < n; ++k) {
      if (std::abs(bearing(by_angle[k]) - ring.first - pitch * static_cast<double>(k)) > kUneven)
        fail<FileError>("{}: {} sonars evenly spaced on a circle expected, sonar {} points to {:.3f} rad", name_, n,
                        by_angle[k], bearing(by_angle[k]));
      ring.radius += Vec2{offsets_[3 * k], offsets_[3 * k + 1]}.norm() / static_cast<double>(n);
    }
    log_.ring = ring;
    for (Scan& scan : scans_) {
      std::vector<double> ranges;
      for (const std::size_t i : by_angle) ranges.push_back(scan.ranges[i]);
      scan.ranges = std::move(ranges);
    }
  }

  /// Where the robot was: between the poses told before and after, the last one at the end.
  void pose_scans() {
    std::size_t before = 0;
    for (Scan& scan : scans_) {
      while (before + 1 < odoms_.size() && odoms_[before + 1].time <= scan.time) ++before;
      if (odoms_.empty() || odoms_[before].time > scan.time) {
        bad_(log_.report.without_pose, scan.line, "an ODOM record before the first scan expected");
        continue;
      }
      const Odom& from = odoms_[before];
      Pose2 pose = from.pose;
      if (before + 1 < odoms_.size()) {
        const Odom& to = odoms_[before + 1];
        pose = between(from.pose, to.pose, (scan.time - from.time) / (to.time - from.time));
      }
      Observation seen;
      seen.time = scan.time;
      seen.period = log_.scans.empty() ? 0 : scan.time - log_.scans.back().time;
      seen.odometry.pose = pose;
      seen.readings.sonar = std::move(scan.ranges);
      seen.readings.sonar_max = options_.range_max;
      seen.readings.sonar_pose.assign(seen.readings.sonar.size(), pose);
      log_.scans.push_back(std::move(seen));
    }
  }

  std::string name_;
  SonarLogOptions options_;
  BadRecordCounter bad_;
  SonarLog log_;
  std::vector<std::string_view> words_;
  int line_ = 0;
  std::vector<Stamp> stamps_;
  std::vector<double> offsets_;
  std::vector<Odom> odoms_;
  std::vector<Scan> scans_;
};

}  // namespace

SonarLog sonar_log_from_carmen(const std::string& text, const std::string& name, const SonarLogOptions& options,
                               const Work& work) {
  validate(options);
  return CarmenReader(name, options).read(text, work);
}

}  // namespace meander
