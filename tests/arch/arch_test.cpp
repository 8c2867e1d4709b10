// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Holds the rules of docs/architecture.md: who may include whom, what stays out of headers, how large things may get.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;
namespace {

using Edges = std::map<std::string, std::set<std::string>>;
const fs::path kRoot = MEANDER_SOURCE_DIR;

std::vector<std::string> lines_of(const fs::path& path) {
  std::ifstream in(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::set<std::string> words_of(const std::string& text) {
  std::istringstream in(text);
  std::set<std::string> words;
  for (std::string word; in >> word;) words.insert(word);
  return words;
}

std::vector<fs::path> sources(const std::vector<std::string>& folders, const std::set<std::string>& suffixes) {
  std::vector<fs::path> found;
  for (const auto& folder : folders)
    if (fs::exists(kRoot / folder))
      for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder))
        if (entry.is_regular_file() && suffixes.count(entry.path().extension().string())) found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

/// Rows "| `folder` | what | uses |" of the table in docs/architecture.md.
Edges table() {
  static const std::regex kRow(R"(^\| `(\w+)` \|.*\|([^|]*)\|$)");
  Edges edges;
  for (const auto& line : lines_of(kRoot / "docs/architecture.md")) {
    std::smatch match;
    if (std::regex_match(line, match, kRow)) edges[match[1]] = words_of(match[2]);
  }
  return edges;
}

std::string folder_of(const fs::path& file) { return fs::relative(file, kRoot / "src").begin()->string(); }

std::string place(const fs::path& file, std::size_t line) {
  return fs::relative(file, kRoot).string() + ":" + std::to_string(line + 1);
}

TEST(Architecture, TableNamesEveryFolder) {
  std::set<std::string> folders;
  for (const auto& entry : fs::directory_iterator(kRoot / "src"))
    if (entry.is_directory()) folders.insert(entry.path().filename().string());
  std::set<std::string> rows;
  for (const auto& [folder, uses] : table()) rows.insert(folder);
  EXPECT_EQ(rows, folders);
}

TEST(Architecture, TableHasNoCycle) {
  Edges left = table();
  for (bool removed = true; removed && !left.empty();) {
    removed = false;
    for (const auto& [folder, uses] : left) {
      if (std::any_of(uses.begin(), uses.end(), [&](const auto& use) { return left.count(use); })) continue;
      left.erase(folder);
      removed = true;
      break;
    }
  }
  for (const auto& [folder, uses] : left) ADD_FAILURE() << "folder in a cycle: " << folder;
}

TEST(Architecture, EveryIncludeIsInTheTable) {
  static const std::regex kInclude(R"(^\s*#\s*include\s+"(\w+)/[^"]*".*)");
  const Edges edges = table();
  for (const auto& file : sources({"src"}, {".cpp", ".hpp"})) {
    const auto folder = folder_of(file);
    const auto lines = lines_of(file);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      std::smatch match;
      if (!std::regex_match(lines[i], match, kInclude) || match[1] == folder) continue;
      EXPECT_TRUE(edges.at(folder).count(match[1])) << place(file, i) << ": " << folder << " -> " << match[1];
    }
  }
}

TEST(Architecture, LinkListsRepeatTheTable) {
  static const std::regex kCall(R"(meander_folder\((\w+)\s+(?:USES\s+([a-z\s]*))?)");
  for (const auto& [folder, uses] : table()) {
    std::ifstream in(kRoot / "src" / folder / "CMakeLists.txt");
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    std::smatch match;
    if (!std::regex_search(text, match, kCall)) {
      EXPECT_EQ(folder, "app") << "src/" << folder << "/CMakeLists.txt does not call meander_folder";
      continue;
    }
    EXPECT_EQ(match[1], folder);
    EXPECT_EQ(words_of(match[2]), uses) << "src/" << folder << "/CMakeLists.txt";
  }
}

TEST(Architecture, OutsideLibrariesStayWhereTheyBelong) {
  const std::vector<std::pair<std::regex, std::function<bool(const std::string&)>>> rules = {
      {std::regex(R"(^\s*#\s*include\s+<(lua|lauxlib|lualib)\.h>.*)"),
       [](const auto& p) { return p.rfind("src/script/", 0) == 0; }},
      {std::regex(R"(^\s*#\s*include\s+<lua\.hpp>.*)"), [](const auto&) { return false; }},
      {std::regex(R"(^\s*#\s*include\s+<readline/.*)"), [](const auto& p) { return p == "src/repl/line.cpp"; }},
      {std::regex(R"(^\s*#\s*include\s+<(opencv2/|nlohmann/|CLI/|boost/geometry).*)"),
       [](const auto& p) { return p.ends_with(".cpp"); }},
      {std::regex(R"(^\s*#\s*include\s+<toml\+\+/.*)"), [](const auto& p) { return p == "src/world/toml_table.hpp"; }},
  };
  for (const auto& file : sources({"src"}, {".cpp", ".hpp"})) {
    const auto lines = lines_of(file);
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (const auto& [pattern, allowed] : rules)
        EXPECT_TRUE(!std::regex_match(lines[i], pattern) || allowed(fs::relative(file, kRoot).string()))
            << place(file, i) << ": " << lines[i];
  }
}

/// A name of a file that a script gives goes through script/file_access, which a sandbox watches.
TEST(Architecture, BindingsTakeFilesAndNoPaths) {
  static const std::regex kPath(
      R"([^\]]\((.*[ ,(])?(std::string&?|std::string_view) (path|file|folder|name_of_file)[,)].*)");
  for (const auto& file : sources({"src/script"}, {".cpp"})) {
    if (!file.filename().string().starts_with("bind_")) continue;
    const auto lines = lines_of(file);
    for (std::size_t i = 0; i < lines.size(); ++i)
      EXPECT_FALSE(std::regex_search(lines[i], kPath)) << place(file, i) << ": InputFile or OutputFile, not a string";
  }
}

TEST(Architecture, FilesAndFunctionsStaySmall) {
  constexpr std::size_t kFileCap = 400, kFunctionCap = 60;
  static const std::regex kOpens(R"(^(?:  )?[A-Za-z~\[].*[)a-z:&>\]] \{$)");
  static const std::regex kNoFunction(R"(^\s*(namespace|struct|class|enum|union|extern|template|using)\b.*)");
  for (const auto& file : sources({"src", "tests", "bench"}, {".cpp", ".hpp"})) {
    const auto lines = lines_of(file);
    EXPECT_LE(lines.size(), kFileCap) << fs::relative(file, kRoot);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (!std::regex_match(lines[i], kOpens) || std::regex_match(lines[i], kNoFunction)) continue;
      const std::string close = (lines[i][0] == ' ' ? "  }" : "}");
      const auto end = std::find_if(lines.begin() + static_cast<std::ptrdiff_t>(i), lines.end(),
                                    [&](const auto& line) { return line.rfind(close, 0) == 0; });
      const auto length = static_cast<std::size_t>(end - lines.begin()) - i + 1;
      EXPECT_LE(length, kFunctionCap) << place(file, i) << ": " << lines[i];
    }
  }
  for (const auto& file : sources({"lua", "examples", "tests"}, {".lua"})) {
    const bool generated = file.parent_path() == kRoot / "lua" / "meta";
    EXPECT_TRUE(generated || lines_of(file).size() <= kFileCap) << fs::relative(file, kRoot);
  }
}

/// Keys like [LM99] or [K86+] in the lines of a file, without the plus.
std::set<std::string> keys_of(const fs::path& file) {
  static const std::regex kKey(R"(\[(LM99|CN|Z|DG|K86|[A-Z]{1,3}\d\d)\+?\])");
  std::set<std::string> keys;
  for (const auto& line : lines_of(file))
    for (std::sregex_iterator it(line.begin(), line.end(), kKey), end; it != end; ++it) keys.insert((*it)[1]);
  return keys;
}

TEST(Architecture, PapersAndCodeNameEachOther) {
  static const std::regex kRow(R"(^\| \[([A-Z0-9]+)\+?\] (?:eq|sec|fig).*\| `(src/[^`:]+)` \|$)");
  const auto listed = keys_of(kRoot / "docs/papers.md");
  for (const auto& file : sources({"src"}, {".cpp", ".hpp"}))
    for (const auto& key : keys_of(file)) EXPECT_TRUE(listed.count(key)) << fs::relative(file, kRoot) << ": " << key;
  for (const auto& line : lines_of(kRoot / "docs/papers.md")) {
    std::smatch match;
    if (!std::regex_match(line, match, kRow)) continue;
    const fs::path file = kRoot / match[2].str();
    EXPECT_TRUE(fs::exists(file) && keys_of(file).count(match[1])) << "docs/papers.md: " << line;
  }
}

TEST(Architecture, EverySourceNamesItsLicence) {
  for (const auto& file :
       sources({"src", "tests", "bench", "lua", "examples", "cmake"}, {".cpp", ".hpp", ".lua", ".cmake"})) {
    const auto lines = lines_of(file);
    const bool named = lines.size() > 1 &&
                       lines[0].find("SPDX-License-Identifier: GPL-3.0-or-later") != std::string::npos &&
                       lines[1].find("SPDX-FileCopyrightText:") != std::string::npos;
    EXPECT_TRUE(named) << fs::relative(file, kRoot);
  }
}

}  // namespace
