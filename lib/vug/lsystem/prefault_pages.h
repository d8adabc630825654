// SPDX-License-Identifier: Apache-2.0
// Internal to rewriting: page faults on new memory before several threads write to it.
#pragma once

#include <cstddef>
#include <initializer_list>

namespace vug::lsystem {

struct MemoryRange {
  void* place;
  size_t bytes;
};

/// Touches the memory in parallel, each huge page (see base/huge_pages.h) by one thread, so that
/// the system clears it. Otherwise two threads that first write to the same page would both clear
/// it, one of them in vain. Overwrites a byte of each page.
void prefault_pages(std::initializer_list<MemoryRange> all);

}  // namespace vug::lsystem
