// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <algorithm>
#include <cmath>

#include "render/plot.hpp"
#include "script/bind.hpp"
#include "script/kit_function.hpp"
#include "script/kit_module.hpp"
#include "script/kit_type.hpp"
#include "script/numbers.hpp"
#include "script/picture.hpp"

namespace meander::script {
namespace {

std::optional<double> at(const Numbers& numbers, lua_Integer i) {
  if (i < 1 || i > static_cast<lua_Integer>(numbers.size())) return std::nullopt;
  return numbers[static_cast<std::size_t>(i - 1)];
}
int length(const Numbers& numbers) { return static_cast<int>(numbers.size()); }

std::vector<double> totable(const Numbers& numbers) {
  std::vector<double> list(numbers.size());
  for (std::size_t i = 0; i < list.size(); ++i) list[i] = numbers[i];
  return list;
}

/// The place of index i, 1 first, negative from the end.
lua_Integer place(const Numbers& numbers, int i) {
  const auto size = static_cast<lua_Integer>(numbers.size());
  return std::clamp<lua_Integer>(i < 0 ? size + 1 + i : i, 1, size + 1);
}

Numbers slice(const Numbers& numbers, int first, const std::optional<int>& last, const std::optional<int>& step) {
  const int by = step.value_or(1);
  if (by < 1) fail("argument 3 ('step'): a number >= 1 expected, got {}", by);
  const lua_Integer from = place(numbers, first);
  const lua_Integer to = std::min<lua_Integer>(place(numbers, last.value_or(-1)), length(numbers));
  const lua_Integer count = to < from ? 0 : (to - from) / by + 1;
  return numbers.slice(static_cast<std::size_t>(from - 1), static_cast<std::size_t>(count),
                       static_cast<std::size_t>(by));
}

Pushed map(const Numbers& numbers, const Function& function, const Call& call) {
  lua_State* L = call.L;
  lua_createtable(L, length(numbers), 0);
  for (int i = 0; i < length(numbers); ++i) {
    function.invoke(1, numbers[static_cast<std::size_t>(i)], i + 1);
    lua_rawseti(L, -2, i + 1);
  }
  return {1};
}

template <class Better>
std::tuple<std::optional<double>, std::optional<int>> extreme(const Numbers& numbers, Better better) {
  if (numbers.size() == 0) return {};
  std::size_t best = 0;
  for (std::size_t i = 1; i < numbers.size(); ++i)
    if (better(numbers[i], numbers[best])) best = i;
  return {numbers[best], static_cast<int>(best) + 1};
}
auto least(const Numbers& numbers) { return extreme(numbers, std::less<>()); }
auto most(const Numbers& numbers) { return extreme(numbers, std::greater<>()); }

double sum(const Numbers& numbers) {
  double total = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) total += numbers[i];
  return total;
}
std::optional<double> mean(const Numbers& numbers) {
  if (numbers.size() == 0) return std::nullopt;
  return sum(numbers) / static_cast<double>(numbers.size());
}

std::string text(const Numbers& numbers) {
  constexpr std::size_t kMostShown = 16;
  std::string text = "{";
  for (std::size_t i = 0; i < std::min(numbers.size(), kMostShown); ++i)
    text += (i ? ", " : "") + (std::isnan(numbers[i]) ? "nan" : fmt::format("{:.6g}", numbers[i]));
  return text + (numbers.size() > kMostShown ? fmt::format(", ... {} in all}}", numbers.size()) : "}");
}

DrawList picture(const Numbers& numbers) { return draw_curve(totable(numbers)); }

Numbers make(const std::vector<double>& list) {
  const auto values = std::make_shared<const std::vector<double>>(list);
  return numbers_of(values, *values);
}

}  // namespace

void bind_numbers(lua_State* L) {
  Module(L, "meander", "")
      .function<&make>(Doc{.name = "numbers",
                           .text = "A native copy of a list, with min, max, mean and slices.",
                           .args = {{"list", "numbers"}},
                           .returns = "the copy",
                           .example = "print(meander.numbers({3, 1, 2}):mean())"});
  Type<Numbers>(L, "A view of native numbers: [i], #, ipairs. It copies nothing and keeps what it shows alive.")
      .method<&totable>(Doc{.name = "totable",
                            .text = "A copy as a plain list.",
                            .returns = "list of numbers",
                            .example = "print(#meander.numbers({3, 1, 2}):totable())"})
      .method<&slice>(Doc{.name = "slice",
                          .text = "A view of a part.",
                          .args = {{"first", "index, 1 first, negative from the end"},
                                   {"last", "index; the last when left out"},
                                   {"step", "every so many; 1 when left out"}},
                          .returns = "the part",
                          .example = "print(meander.numbers({3, 1, 2}):slice(1, 4))"})
      .method<&map>(Doc{.name = "map",
                        .text = "A list of what a function makes of each number.",
                        .args = {{"function", "function(number, index) that returns a value"}},
                        .returns = "list of what it returned",
                        .returns_type = "list of any",
                        .errors = "those of the function",
                        .example = "meander.numbers({3, 1, 2}):map(math.floor)"})
      .method<&least>(Doc{.name = "min",
                          .text = "The smallest number and where it is.",
                          .returns = "number and index, nil when there are none",
                          .example = "print(meander.numbers({3, 1, 2}):min())"})
      .method<&most>(Doc{.name = "max",
                         .text = "The largest number and where it is.",
                         .returns = "number and index, nil when there are none",
                         .example = "print(meander.numbers({3, 1, 2}):max())"})
      .method<&sum>(Doc{
          .name = "sum", .text = "The sum.", .returns = "number", .example = "print(meander.numbers({3, 1, 2}):sum())"})
      .method<&mean>(Doc{.name = "mean",
                         .text = "The mean.",
                         .returns = "number, nil when there are none",
                         .example = "print(meander.numbers({3, 1, 2}):mean())"})
      .length<&length>()
      .element<&at>()
      .text<&text>()
      .picture<&picture>();
}

}  // namespace meander::script
