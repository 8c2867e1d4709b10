// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace meander {

/// One command of a transcript, with what it must do.
struct TranscriptStep {
  int line = 0;                      ///< of the command in its file
  std::vector<std::string> above{};  ///< comments and empty lines before the command
  std::string command{};
  std::vector<std::string> input{}, out{}, err{};
  int exit_code = 0;
};

struct Transcript {
  std::vector<TranscriptStep> steps;
  std::vector<std::string> below;  ///< comments after the last command
};

/// Throws FileError at a line of no known form.
Transcript parse_transcript(const std::string& path, const std::string& text);
std::string transcript_text(const Transcript& transcript);

/// `{*}` in `expected` stands for any text.
bool line_matches(std::string_view expected, std::string_view actual);

/// What differs between what was expected and what came, for people; empty when nothing does.
std::string difference(const TranscriptStep& expected, const TranscriptStep& actual);

/// What came, but with the expected form of every line that matches: keeps the wildcards.
TranscriptStep blessed(const TranscriptStep& expected, const TranscriptStep& actual);

}  // namespace meander
