// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "script/docs.hpp"

#include <algorithm>

namespace meander::script {
namespace {

/// Methods may be asked for with a dot.
std::string dotted(std::string_view name) {
  std::string result(name);
  std::replace(result.begin(), result.end(), ':', '.');
  return result;
}

}  // namespace

std::string Record::name() const {
  if (owner.empty()) return member;
  if (member.empty()) return owner;
  return owner + (kind == DocKind::method ? ":" : ".") + member;
}

bool Record::takes_options() const { return arguments.size() == 1 && arguments[0].type == "table"; }

std::string Record::signature() const {
  if (kind != DocKind::function && kind != DocKind::method) return name();
  if (takes_options()) return name() + " { options }";
  std::string text = name() + "(";
  bool first = true;
  for (const ArgumentDoc& argument : arguments) {
    text += (first ? "" : ", ") + argument.name + (argument.optional ? "?" : "");
    first = false;
  }
  return text + ")";
}

Record& Docs::add(Record record) {
  if (record.kind == DocKind::metamethod) return events_.emplace_back(std::move(record));
  records_.push_back(std::move(record));
  by_name_[dotted(records_.back().name())] = &records_.back();
  return records_.back();
}

const Record* Docs::find(std::string_view name) const {
  const auto found = by_name_.find(dotted(name));
  return found == by_name_.end() ? nullptr : found->second;
}

std::vector<const Record*> Docs::members(std::string_view owner) const {
  std::vector<const Record*> result;
  for (const Record& record : records_)
    if (record.owner == owner && !record.member.empty()) result.push_back(&record);
  return result;
}

const Record* Docs::element(std::string_view owner) const {
  const auto found = std::find_if(events_.begin(), events_.end(), [&](const Record& record) {
    return record.owner == owner && record.member == kElementName;
  });
  return found == events_.end() ? nullptr : &*found;
}

}  // namespace meander::script
