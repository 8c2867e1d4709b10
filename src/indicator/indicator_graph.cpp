// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/indicator_graph.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/angle.hpp"

namespace meander {
namespace {

void check_position(const Vec2& position) {
  if (!position.allFinite()) fail("indicator: finite position expected, got ({}, {})", position.x(), position.y());
}

void check_length(double length) {
  if (!(length > 0) || !std::isfinite(length)) fail("link: a length > 0 [m] expected, got {}", length);
}

}  // namespace

IndicatorId IndicatorGraph::place(const Vec2& position) {
  check_position(position);
  while (no_free_before_ < slots_.size() && slots_[no_free_before_].indicator) ++no_free_before_;
  const std::size_t index = no_free_before_;
  if (index == slots_.size()) slots_.emplace_back();
  Slot& slot = slots_[index];
  const IndicatorId id{static_cast<std::uint32_t>(index), ++slot.generation};
  slot.indicator = Indicator{.id = id, .position = position, .ports = {}, .links = {}};
  ++living_;
  ++revision_;
  return id;
}

void IndicatorGraph::remove(IndicatorId id) {
  while (!at(id).links.empty()) unlink(at(id).links.back());
  slots_[id.slot].indicator.reset();
  no_free_before_ = std::min(no_free_before_, std::size_t{id.slot});
  --living_;
  ++revision_;
}

void IndicatorGraph::move(IndicatorId id, const Vec2& position) {
  check_position(position);
  at(id).position = position;
  ++revision_;
}

int IndicatorGraph::add_port(IndicatorId id, double direction, double reach) {
  if (!std::isfinite(direction) || !std::isfinite(reach) || reach < 0)
    fail("port: a finite direction [rad] and a reach >= 0 [m] expected, got {} and {}", direction, reach);
  Port port;
  port.direction = wrap_angle(direction);
  port.reach = reach;
  std::vector<Port>& ports = at(id).ports;
  ports.push_back(port);
  ++revision_;
  return static_cast<int>(ports.size()) - 1;
}

void IndicatorGraph::set_ports(IndicatorId id, std::vector<Port> ports) {
  for (const Port& port : at(id).ports)
    if (port.link >= 0) fail("indicator {}: it has ports that are linked", id.slot + 1);
  for (const Port& port : ports)
    if (port.link >= 0 || port.state == PortState::linked)
      fail("indicator {}: ports that are not linked expected", id.slot + 1);
  at(id).ports = std::move(ports);
  ++revision_;
}

int IndicatorGraph::link(const PortRef& a, const PortRef& b, double length) {
  check_length(length);
  at(a.indicator), at(b.indicator);
  if (a == b) fail("link: two ends expected, got the same port twice");
  if (a.port < 0 && a.indicator == b.indicator) fail("link: a link by sight joins two indicators");
  for (const PortRef& end : {a, b})
    if (end.port >= 0 && at(end).link >= 0) unlink(at(end).link);
  const int index = static_cast<int>(links_.size());
  links_.push_back({a, b, length});
  for (const PortRef& end : {a, b}) {
    at(end.indicator).links.push_back(index);
    if (end.port < 0) continue;
    Port& port = at(end);
    port.state = PortState::linked;
    port.link = index;
    port.tries = 0;
    port.failures = 0;
    port.closed_run = 0;
  }
  ++revision_;
  return index;
}

void IndicatorGraph::set_length(int link, double length) {
  check_length(length);
  links_.at(static_cast<std::size_t>(link)).length = length;
  ++revision_;
}

/// Takes one mention of the link out of its end.
void IndicatorGraph::detach(const PortRef& end, int link) {
  std::vector<int>& mentioned = at(end.indicator).links;
  mentioned.erase(std::find(mentioned.begin(), mentioned.end(), link));
  if (end.port < 0) return;
  at(end).link = -1;
  at(end).state = PortState::unknown;
}

void IndicatorGraph::unlink(int link) {
  const Link gone = links_.at(static_cast<std::size_t>(link));
  detach(gone.a, link);
  detach(gone.b, link);
  const int last = static_cast<int>(links_.size()) - 1;
  if (link != last) {  // the last one moves into the gap
    links_[static_cast<std::size_t>(link)] = links_.back();
    for (const PortRef& end : {links_.back().a, links_.back().b}) {
      std::vector<int>& mentioned = at(end.indicator).links;
      std::replace(mentioned.begin(), mentioned.end(), last, link);
      if (end.port >= 0) at(end).link = link;
    }
  }
  links_.pop_back();
  ++revision_;
}

void IndicatorGraph::close(const PortRef& ref, PortState state, int run) {
  Port& port = at(ref);
  port.state = state;
  port.closed_run = run;
  ++port.failures;
  ++revision_;
}

void IndicatorGraph::block(const PortRef& ref, int run) {
  const std::optional<PortRef> far = other_end(ref);
  if (far) unlink(at(ref).link);
  close(ref, PortState::blocked, run);
  if (far && far->port >= 0) close(*far, PortState::blocked, run);
}

void IndicatorGraph::give_up(const PortRef& ref, int run) {
  if (at(ref).link >= 0) unlink(at(ref).link);
  close(ref, PortState::dead_end, run);
}

void IndicatorGraph::reopen(const PortRef& ref) {
  Port& port = at(ref);
  if (port.state == PortState::linked) return;
  port.state = PortState::unknown;
  port.tries = 0;
  ++revision_;
}

void IndicatorGraph::set_tries(const PortRef& ref, int tries) {
  at(ref).tries = tries;
  ++revision_;
}

void IndicatorGraph::set_seen(const PortRef& ref, double reach, int misses) {
  Port& port = at(ref);
  if (port.reach == reach && port.misses == misses) return;
  port.reach = reach;
  port.misses = misses;
  ++revision_;
}

void IndicatorGraph::pass(const PortRef& ref) { ++at(ref).passed; }

bool IndicatorGraph::alive(IndicatorId id) const {
  return id.slot < slots_.size() && slots_[id.slot].indicator && slots_[id.slot].generation == id.generation;
}

const Indicator& IndicatorGraph::get(IndicatorId id) const {
  if (!alive(id)) fail<StaleError>("indicator {} was removed", id.slot + 1);
  return *slots_[id.slot].indicator;
}

Indicator& IndicatorGraph::at(IndicatorId id) { return const_cast<Indicator&>(get(id)); }

const Port& IndicatorGraph::port(const PortRef& ref) const {
  const Indicator& indicator = get(ref.indicator);
  if (ref.port < 0 || ref.port >= static_cast<int>(indicator.ports.size()))
    fail("indicator {}: it has {} ports, there is no port {}", ref.indicator.slot + 1, indicator.ports.size(),
         ref.port + 1);
  return indicator.ports[static_cast<std::size_t>(ref.port)];
}

Port& IndicatorGraph::at(const PortRef& ref) { return const_cast<Port&>(port(ref)); }

std::vector<IndicatorId> IndicatorGraph::ids() const {
  std::vector<IndicatorId> ids;
  for (const Slot& slot : slots_)
    if (slot.indicator) ids.push_back(slot.indicator->id);
  return ids;
}

const Indicator* IndicatorGraph::in_slot(std::size_t slot) const {
  return slot < slots_.size() && slots_[slot].indicator ? &*slots_[slot].indicator : nullptr;
}

std::optional<PortRef> IndicatorGraph::other_end(const PortRef& ref) const {
  const int link = port(ref).link;
  if (link < 0) return std::nullopt;
  const Link& way = links_[static_cast<std::size_t>(link)];
  return way.a == ref ? way.b : way.a;
}

IndicatorId IndicatorGraph::restore(std::uint32_t generation, const std::optional<Indicator>& indicator) {
  const auto slot = static_cast<std::uint32_t>(slots_.size());
  slots_.push_back({generation, indicator});
  if (indicator) {
    check_position(indicator->position);
    slots_.back().indicator->id = {slot, generation};
    slots_.back().indicator->links.clear();
    ++living_;
  }
  ++revision_;
  return {slot, generation};
}

}  // namespace meander
