// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <tbb/info.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "base/work.hpp"

namespace meander {

/// Runs make(i) for i = 0 .. count - 1 on `threads` threads (0, or more than there are: all cores) and hands each
/// result to take(i, result) on one thread at a time, in the order of i, whatever finishes first. The first exception
/// ends the loop and is rethrown.
template <class Make, class Take>
void ordered_parallel(std::size_t count, int threads, const Work& work, Make make, Take take) {
  using Result = std::invoke_result_t<Make, std::size_t>;
  struct Item {
    std::size_t index;
    Result result;
  };
  std::size_t next = 0;
  const int cores = tbb::info::default_concurrency();
  tbb::task_arena arena(threads > 0 ? std::min(threads, cores) : cores);
  arena.execute([&] {
    const auto in_flight = static_cast<std::size_t>(4 * tbb::this_task_arena::max_concurrency());
    tbb::parallel_pipeline(in_flight,
                           tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order,
                                                               [&](tbb::flow_control& control) -> std::size_t {
                                                                 if (next == count) return control.stop(), next;
                                                                 return next++;
                                                               }) &
                               tbb::make_filter<std::size_t, Item>(tbb::filter_mode::parallel,
                                                                   [&](std::size_t i) {
                                                                     work.poll();
                                                                     return Item{i, make(i)};
                                                                   }) &
                               tbb::make_filter<Item, void>(tbb::filter_mode::serial_in_order, [&](Item item) {
                                 take(item.index, std::move(item.result));
                                 work.report(static_cast<double>(item.index + 1) / static_cast<double>(count), "");
                               }));
  });
}

}  // namespace meander
