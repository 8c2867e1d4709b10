// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "repl/history.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include "base/atomic_file.hpp"
#include "base/error.hpp"

namespace meander::repl {
namespace fs = std::filesystem;
namespace {

/// One entry, one line of the file.
std::string escaped(const std::string& entry) {
  std::string line;
  for (const char c : entry) {
    if (c == '\\')
      line += "\\\\";
    else if (c == '\n')
      line += "\\n";
    else
      line += c;
  }
  return line;
}

std::string unescaped(const std::string& line) {
  std::string entry;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\\' && i + 1 < line.size())
      entry += line[++i] == 'n' ? '\n' : line[i];
    else
      entry += line[i];
  }
  return entry;
}

/// Keeps the newest of equal entries and the newest kMost of all.
std::vector<std::string> newest_of_each(const std::vector<std::string>& all) {
  std::set<std::string> seen;
  std::vector<std::string> kept;
  for (auto entry = all.rbegin(); entry != all.rend() && kept.size() < History::kMost; ++entry)
    if (!entry->empty() && seen.insert(*entry).second) kept.push_back(*entry);
  std::reverse(kept.begin(), kept.end());
  return kept;
}

bool append_privately(const std::string& path, const std::string& line) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (file < 0) return false;
  const bool written = write(file, line.data(), line.size()) == static_cast<ssize_t>(line.size());
  return close(file) == 0 && written;
}

std::string below_home(const char* variable, const char* standard, const char* rest) {
  if (const char* base = std::getenv(variable); base && *base == '/') return std::string(base) + rest;
  const char* home = std::getenv("HOME");
  return home && *home ? std::string(home) + standard + rest : std::string();
}

}  // namespace

History::History(std::string path) : path_(std::move(path)) {
  if (path_.empty()) return;
  std::error_code ignored;  // add() tells when the file cannot be written
  fs::create_directories(fs::path(path_).parent_path(), ignored);
  load();
}

void History::load() {
  std::vector<std::string> all;
  std::ifstream file(path_);
  for (std::string line; std::getline(file, line);) all.push_back(unescaped(line));
  entries_ = newest_of_each(all);
  if (all.size() < entries_.size() + kMost / 10) return;
  std::string text;
  for (const std::string& entry : entries_) text += escaped(entry) + '\n';
  try {
    write_file_atomically(path_, text);
  } catch (const FileError&) {
    return;  // a read-only file still serves
  }
}

bool History::add(const std::string& entry) {
  if (entry.empty() || (!entries_.empty() && entries_.back() == entry)) return true;
  std::erase(entries_, entry);
  entries_.push_back(entry);
  if (entries_.size() > kMost) entries_.erase(entries_.begin());
  return path_.empty() || append_privately(path_, escaped(entry) + '\n');
}

std::string history_path() { return below_home("XDG_STATE_HOME", "/.local/state", "/meander/history"); }

std::string start_up_path() { return below_home("XDG_CONFIG_HOME", "/.config", "/meander/init.lua"); }

}  // namespace meander::repl
