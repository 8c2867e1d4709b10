// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
// Counts what the program allocates. By itself, so that the compiler sees no call and replaces nothing inline.
#include <cstdlib>
#include <new>

namespace {
std::size_t count = 0;
}  // namespace

namespace meander {
std::size_t allocations() { return count; }
}  // namespace meander

void* operator new(std::size_t size) {
  ++count;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
