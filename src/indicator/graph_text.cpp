// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "indicator/graph_text.hpp"

#include <algorithm>
#include <tuple>

#include "geometry/angle.hpp"

namespace meander {
namespace {

constexpr int kMost = 1 << 30;

std::string end_text(const PortRef& end) {
  const std::string serial = fmt::format("{}", end.indicator.slot + 1);
  return end.port < 0 ? serial : fmt::format("{}.{}", serial, end.port + 1);
}

auto key(const PortRef& end) { return std::pair(end.indicator.slot, end.port); }

/// Each link from its lower end, in the order of the ends: how links came about does not show.
std::vector<Link> sorted_links(const IndicatorGraph& graph) {
  std::vector<Link> links = graph.links();
  for (Link& link : links)
    if (key(link.b) < key(link.a)) std::swap(link.a, link.b);
  std::sort(links.begin(), links.end(), [](const Link& x, const Link& y) {
    return std::tuple(key(x.a), key(x.b), x.length) < std::tuple(key(y.a), key(y.b), y.length);
  });
  return links;
}

class GraphReader {
 public:
  explicit GraphReader(TextLines& lines) : lines_(lines) {}

  IndicatorGraph read() {
    bool ended = false;
    while (!ended && lines_.next()) {
      if (lines_.is("end"))
        ended = true;
      else if (lines_.is("indicator"))
        indicator();
      else if (lines_.is("port"))
        port();
      else if (lines_.is("free"))
        free();
      else if (lines_.is("link"))
        link();
      else
        lines_.wrong("'indicator', 'port', 'free', 'link' or 'end' expected, got '{}'", lines_.shown(0));
    }
    if (!ended) lines_.wrong("the file is cut off: 'end' expected in its last line");
    lines_.count(1, "end");
    finish_slots();
    if (linked_ != 0) lines_.wrong("{} ports are linked, but no link says where to", linked_);
    if (lines_.next()) lines_.wrong("nothing expected after 'end', got '{}'", lines_.shown(0));
    return std::move(graph_);
  }

 private:
  std::uint32_t slot() {
    if (in_links_) lines_.wrong("indicators come before links");
    flush();
    const auto expected = static_cast<int>(graph_.slots()) + 1;
    if (lines_.integer(1, 1, kMost) != expected) lines_.wrong("serial number {} expected", expected);
    return lines_.integer<std::uint32_t>(2, 1, kMost);
  }
  void indicator() {
    lines_.count(5, "indicator SERIAL GENERATION X Y");
    generation_ = slot();
    open_ = Indicator{};
    open_->position = {lines_.number(3), lines_.number(4)};
  }
  void free() {
    lines_.count(3, "free SERIAL GENERATION");
    graph_.restore(slot(), std::nullopt);
  }
  void port() {
    lines_.count(10, "port DIRECTION REACH STATE TRIES PASSED FAILURES CLOSED_RUN MISSES BOUND");
    if (!open_) lines_.wrong("a port comes after its indicator");
    Port port;
    port.direction = lines_.number(1);
    if (wrap_angle(port.direction) != port.direction) lines_.wrong("a direction in (-pi, pi] expected");
    port.reach = lines_.number(2);
    if (port.reach < 0) lines_.wrong("a reach >= 0 expected");
    const auto state = enum_from<PortState>(lines_.words()[3]);
    if (!state)
      lines_.wrong("unknown state '{}'{}", lines_.shown(3), did_you_mean(lines_.shown(3), enum_names<PortState>()));
    port.state = *state;
    port.tries = lines_.integer(4, 0, kMost);
    port.passed = lines_.integer(5, 0, kMost);
    port.failures = lines_.integer(6, 0, kMost);
    port.closed_run = lines_.integer(7, 0, kMost);
    port.misses = lines_.integer(8, 0, kMost);
    port.bound = lines_.number(9);
    if (port.bound < 0) lines_.wrong("a bound >= 0 expected");
    const bool linked = port.state == PortState::linked;
    if (linked && (port.tries | port.failures | port.closed_run) != 0)
      lines_.wrong("a linked port has no tries, failures or closed run");
    linked_ += linked;
    open_->ports.push_back(port);
  }
  void flush() {
    if (open_) graph_.restore(generation_, open_);
    open_.reset();
  }
  void finish_slots() {
    if (!in_links_) flush();
    in_links_ = true;
  }
  void link() {
    lines_.count(4, "link END END LENGTH");
    finish_slots();
    const PortRef a = end(1), b = end(2);
    const double length = lines_.number(3);
    if (!(length > 0)) lines_.wrong("a length > 0 expected");
    if (a == b || (a.indicator == b.indicator && (a.port < 0 || b.port < 0))) lines_.wrong("two ends expected");
    graph_.link(a, b, length);
  }
  PortRef end(std::size_t word) {
    const std::string_view text = lines_.words()[word];
    const std::size_t dot = std::min(text.find('.'), text.size());
    const int slot = whole(text.substr(0, dot), word) - 1;
    const Indicator* indicator = slot < 0 ? nullptr : graph_.in_slot(static_cast<std::size_t>(slot));
    if (!indicator) lines_.wrong("there is no indicator '{}'", lines_.shown(word));
    if (dot == text.size()) return {indicator->id};
    const int port = whole(text.substr(dot + 1), word) - 1;
    if (port < 0 || port >= static_cast<int>(indicator->ports.size()))
      lines_.wrong("there is no port '{}'", lines_.shown(word));
    const PortRef ref{indicator->id, port};
    if (graph_.port(ref).state != PortState::linked || graph_.port(ref).link >= 0)
      lines_.wrong("port '{}' is not linked, or linked already", lines_.shown(word));
    --linked_;
    return ref;
  }
  int whole(std::string_view text, std::size_t word) const {
    int value = 0;
    const auto [last, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || last != text.data() + text.size())
      lines_.wrong("an end like 3.1 expected, got '{}'", lines_.shown(word));
    return value;
  }

  TextLines& lines_;
  IndicatorGraph graph_;
  std::optional<Indicator> open_;
  std::uint32_t generation_ = 1;
  int linked_ = 0;  ///< ports whose link is still to come
  bool in_links_ = false;
};

}  // namespace

std::string graph_lines(const IndicatorGraph& graph) {
  std::string text;
  const auto out = std::back_inserter(text);
  for (std::size_t slot = 0; slot < graph.slots(); ++slot) {
    const Indicator* indicator = graph.in_slot(slot);
    if (!indicator) {
      fmt::format_to(out, "free {} {}\n", slot + 1, graph.generation(slot));
      continue;
    }
    fmt::format_to(out, "indicator {} {} {} {}\n", slot + 1, indicator->id.generation, indicator->position.x(),
                   indicator->position.y());
    for (const Port& port : indicator->ports)
      fmt::format_to(out, "port {} {} {} {} {} {} {} {} {}\n", port.direction, port.reach, to_string(port.state),
                     port.tries, port.passed, port.failures, port.closed_run, port.misses, port.bound);
  }
  for (const Link& link : sorted_links(graph))
    fmt::format_to(out, "link {} {} {}\n", end_text(link.a), end_text(link.b), link.length);
  return text + "end\n";
}

IndicatorGraph read_graph_lines(TextLines& lines) { return GraphReader(lines).read(); }

}  // namespace meander
