// Inside of rewriting only: new memory before several threads write to it.
#pragma once

#include <cstddef>
#include <initializer_list>

namespace vug::lsystem {

struct MemoryRange {
  void* place;
  size_t bytes;
};

/// Has the system clear what will be written next, all threads at once and each large page (see
/// base/huge_pages.h) by one of them. As they come to it while writing, two threads on one page
/// would both clear it, and one in vain. Overwrites a byte of each page.
void prefault_pages(std::initializer_list<MemoryRange> all);

}  // namespace vug::lsystem
