// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "transcript.hpp"

#include <fmt/format.h>

#include <charconv>
#include <sstream>

#include "base/error.hpp"

namespace meander {
namespace {

using Lines = std::vector<std::string>;

/// The rest of `line` behind `mark`; a line that consists of the mark alone stands for an empty text.
bool take(const std::string& line, std::string_view mark, Lines& lines) {
  if (line.starts_with(mark)) return lines.push_back(line.substr(mark.size())), true;
  if (line + " " == mark) return lines.emplace_back(), true;
  return false;
}

bool take_exit(const std::string& line, int& code) {
  constexpr std::string_view kMark = "exit ";
  if (!line.starts_with(kMark)) return false;
  const char* end = line.data() + line.size();
  return std::from_chars(line.data() + kMark.size(), end, code).ptr == end;
}

bool take_expectation(const std::string& line, TranscriptStep& step) {
  return take(line, "< ", step.input) || take(line, "out| ", step.out) || take(line, "err| ", step.err) ||
         take_exit(line, step.exit_code);
}

void put(std::string& text, std::string_view mark, const Lines& lines) {
  for (const std::string& line : lines) {
    text += std::string(mark) + line;
    while (text.ends_with(' ')) text.pop_back();
    text += '\n';
  }
}

std::string line_difference(const char* name, const Lines& expected, const Lines& actual) {
  std::string text;
  for (std::size_t i = 0; i < std::max(expected.size(), actual.size()); ++i) {
    if (i < expected.size() && i < actual.size() && line_matches(expected[i], actual[i])) continue;
    if (i < expected.size()) text += fmt::format("  - {}| {}\n", name, expected[i]);
    if (i < actual.size()) text += fmt::format("  + {}| {}\n", name, actual[i]);
  }
  return text;
}

Lines blessed_lines(const Lines& expected, const Lines& actual) {
  Lines lines = actual;
  for (std::size_t i = 0; i < std::min(expected.size(), actual.size()); ++i)
    if (line_matches(expected[i], actual[i])) lines[i] = expected[i];
  return lines;
}

}  // namespace

Transcript parse_transcript(const std::string& path, const std::string& text) {
  Transcript transcript;
  Lines loose;
  std::istringstream stream(text);
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (line.starts_with("$ ")) {
      transcript.steps.push_back({.line = number, .above = std::move(loose), .command = line.substr(2)});
      loose.clear();
    } else if (line.empty() || line[0] == '#') {
      loose.push_back(line);
    } else if (transcript.steps.empty() || !take_expectation(line, transcript.steps.back())) {
      fail<FileError>("{}:{}: '$ ', '< ', 'out| ', 'err| ', 'exit N' or '#' expected", path, number);
    }
  }
  transcript.below = std::move(loose);
  return transcript;
}

std::string transcript_text(const Transcript& transcript) {
  std::string text;
  for (const TranscriptStep& step : transcript.steps) {
    put(text, "", step.above);
    text += "$ " + step.command + '\n';
    put(text, "< ", step.input);
    put(text, "out| ", step.out);
    put(text, "err| ", step.err);
    if (step.exit_code) text += fmt::format("exit {}\n", step.exit_code);
  }
  put(text, "", transcript.below);
  return text;
}

bool line_matches(std::string_view expected, std::string_view actual) {
  constexpr std::string_view kAny = "{*}";
  const std::size_t any = expected.find(kAny);
  const std::string_view start = expected.substr(0, any);
  if (!actual.starts_with(start)) return false;
  if (any == std::string_view::npos) return actual == expected;
  const std::string_view rest = expected.substr(any + kAny.size());
  for (std::size_t from = start.size(); from <= actual.size(); ++from)
    if (line_matches(rest, actual.substr(from))) return true;
  return false;
}

std::string difference(const TranscriptStep& expected, const TranscriptStep& actual) {
  std::string text =
      line_difference("out", expected.out, actual.out) + line_difference("err", expected.err, actual.err);
  if (expected.exit_code != actual.exit_code)
    text += fmt::format("  - exit {}\n  + exit {}\n", expected.exit_code, actual.exit_code);
  return text;
}

TranscriptStep blessed(const TranscriptStep& expected, const TranscriptStep& actual) {
  TranscriptStep step = actual;
  step.out = blessed_lines(expected.out, actual.out);
  step.err = blessed_lines(expected.err, actual.err);
  return step;
}

}  // namespace meander
