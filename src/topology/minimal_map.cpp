// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "topology/minimal_map.hpp"

#include <algorithm>

namespace meander::topology {
namespace {

NetOptions slower(NetOptions net, const MinimalOptions& options) {
  net.adapt *= options.adapt;
  net.adapt_neighbours *= options.adapt;
  net.fade = options.fade;
  return net;
}

constexpr std::size_t kLinkBytes = 4;       ///< number of the other cell (3) and a weight of one byte, per half link
constexpr std::size_t kSenseLinkBytes = 2;  ///< two numbers below 256 per place

}  // namespace

MinimalMap::MinimalMap(const MinimalOptions& options, const NetOptions& net, const Scales& scales, int touch, int light)
    : options_(options),
      accept_(net.accept_distance),
      geometry_(net, SenseMetric(0, 0, scales), scales.position),
      light_(slower(net, options), SenseMetric(0, light, {scales.position, options.light_scale, scales.touch}), 0),
      touch_(slower(net, options), SenseMetric(touch, 0, scales), 0),
      light_row_(static_cast<std::size_t>(light_.metric().stride())),
      touch_row_(static_cast<std::size_t>(touch_.metric().stride())) {}

void MinimalMap::present(const Situation& situation, std::int64_t sample) {
  // [Z] section 3-5: the situation is divided into its geometry, light and touch.
  const int touch = touch_.metric().touch(), light = light_.metric().light();
  std::copy_n(situation.senses, touch, touch_row_.begin());
  std::copy_n(situation.senses + touch, light, light_row_.begin());
  const Match g = geometry_.present({situation.position, nullptr}, sample);         // [Z] eq. (9)
  const Match l = light_.present({situation.position, light_row_.data()}, sample);  // [Z] eq. (10)
  const Match t = touch_.present({situation.position, touch_row_.data()}, sample);  // [Z] eq. (11)
  if (g.distance > options_.stable_place * accept_) return;
  if (std::max(l.distance, t.distance) > options_.stable_senses * accept_) return;
  const SenseLink to_light = link_to(light_, l.cell), to_touch = link_to(touch_, t.cell);
  const SenseLink light_now = light_of(g.cell), touch_now = touch_of(g.cell);
  const bool differs = (light_now.cell >= 0 && light_now != to_light) || (touch_now.cell >= 0 && touch_now != to_touch);
  if (!differs) return set_links(g.cell, to_light, to_touch);  // [Z] eqs. (12), (13)
  // Another "spontaneous insertion": the places must tell every border of a light or a touch.
  if (neighbour_says(g.cell, situation.position, to_light, to_touch)) return;
  const int made = geometry_.insert({situation.position, nullptr}, sample, g.cell);
  set_links(made, to_light, to_touch);
}

MinimalMap::PlaceLinks MinimalMap::links_of(int place) const {
  const auto i = static_cast<std::size_t>(place);
  // The number of a place that went may stand for another now.
  return i < links_.size() && links_[i].serial == geometry_.cells()[place].serial ? links_[i] : PlaceLinks{};
}

SenseLink MinimalMap::valid(const GrowingNet& net, const SenseLink& link) {
  return net.cells().alive(link.cell) && net.cells()[link.cell].serial == link.serial ? link : SenseLink{};
}

bool MinimalMap::neighbour_says(int place, const Vec2& at, const SenseLink& light, const SenseLink& touch) const {
  const auto& links = geometry_.cells()[place].links;
  return std::any_of(links.begin(), links.end(), [&](const Link& link) {
    return (geometry_.cells()[link.to].position - at).norm() <= options_.jitter && light_of(link.to) == light &&
           touch_of(link.to) == touch;
  });
}

void MinimalMap::set_links(int place, const SenseLink& light, const SenseLink& touch) {
  const auto i = static_cast<std::size_t>(place);
  if (i >= links_.size()) links_.resize(i + 1);
  links_[i] = {geometry_.cells()[place].serial, light, touch};
}

std::size_t map_bytes(const GrowingNet& net, std::size_t value) {
  // A cell: position and senses; half a link: the other's number and the weight.
  const auto senses = static_cast<std::size_t>(net.metric().touch() + net.metric().light());
  const std::size_t place = net.spatial() ? 2 : 0;
  std::size_t bytes = 0;
  for (int cell = 0; cell < net.cells().slots(); ++cell)
    if (net.cells()[cell].alive()) bytes += value * (place + senses) + kLinkBytes * net.cells()[cell].links.size();
  return bytes;
}

std::size_t map_bytes(const MinimalMap& map, std::size_t value) {
  return map_bytes(map.geometry(), value) + map_bytes(map.light(), value) + map_bytes(map.touch(), value) +
         kSenseLinkBytes * static_cast<std::size_t>(map.geometry().cells().size());
}

}  // namespace meander::topology
