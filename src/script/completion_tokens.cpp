// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/completion_tokens.hpp"

#include <algorithm>
#include <cctype>
#include <string>

namespace meander::script {
namespace {

using Kind = Token::Kind;

bool name_start(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool name_part(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

class Splitter {
 public:
  explicit Splitter(std::string_view lua) : lua_(lua) {}

  std::vector<Token> run() {
    while (at_ < lua_.size()) step();
    return std::move(tokens_);
  }

 private:
  void step() {
    const char c = lua_[at_];
    if (std::isspace(static_cast<unsigned char>(c))) {
      ++at_;
    } else if (name_start(c)) {
      take(Kind::name, end_while(name_part));
    } else if (std::isdigit(static_cast<unsigned char>(c))) {
      take(Kind::number, end_while([](char part) { return name_part(part) || part == '.'; }));
    } else if (lua_.substr(at_, 2) == "--") {
      comment();
    } else if (c == '"' || c == '\'') {
      quoted(c);
    } else if (!long_text(at_, Kind::text, Kind::open_text)) {
      take(Kind::symbol, at_ + (lua_.substr(at_, 2) == ".." || lua_.substr(at_, 2) == "::" ? 2 : 1));
    }
  }

  template <class Predicate>
  std::size_t end_while(Predicate part) const {
    std::size_t end = at_;
    while (end < lua_.size() && part(lua_[end])) ++end;
    return end;
  }

  void take(Kind kind, std::size_t end) {
    tokens_.push_back({kind, lua_.substr(at_, end - at_), at_});
    at_ = end;
  }

  void comment() {
    const std::size_t start = at_;
    const std::size_t count = tokens_.size();
    if (long_text(at_ + 2, Kind::text, Kind::open_comment)) {
      if (tokens_.back().kind != Kind::open_comment) tokens_.resize(count);
      return;
    }
    const std::size_t end = lua_.find('\n', start);
    if (end == std::string_view::npos) tokens_.push_back({Kind::open_comment, lua_.substr(start), start});
    at_ = std::min(end, lua_.size());
  }

  void quoted(char quote) {
    std::size_t end = at_ + 1;
    while (end < lua_.size() && lua_[end] != quote && lua_[end] != '\n') end += lua_[end] == '\\' ? 2 : 1;
    const bool open = end >= lua_.size();
    end = std::min(end, lua_.size());
    tokens_.push_back({open ? Kind::open_text : Kind::text, lua_.substr(at_ + 1, end - at_ - 1), at_});
    at_ = open ? end : end + 1;
  }

  /// [[...]], [=[...]=] and so on, which begins at `from`.
  bool long_text(std::size_t from, Kind closed, Kind open) {
    if (from >= lua_.size() || lua_[from] != '[') return false;
    const std::size_t second = lua_.find_first_not_of('=', from + 1);
    if (second == std::string_view::npos || lua_[second] != '[') return false;
    const std::string end_mark = "]" + std::string(second - from - 1, '=') + "]";
    const std::size_t end = lua_.find(end_mark, second + 1);
    const bool found = end != std::string_view::npos;
    tokens_.push_back({found ? closed : open, lua_.substr(second + 1, found ? end - second - 1 : end), at_});
    at_ = found ? end + end_mark.size() : lua_.size();
    return true;
  }

  std::string_view lua_;
  std::size_t at_ = 0;
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> tokens_of(std::string_view lua) { return Splitter(lua).run(); }

}  // namespace meander::script
