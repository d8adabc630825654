// SPDX-License-Identifier: Apache-2.0
#include <vug/base/huge_pages.h>
#include <vug/base/parallel.h>
#include <vug/lsystem/prefault_pages.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace vug::lsystem {

void prefault_pages(std::initializer_list<MemoryRange> all) {
  std::vector<volatile char*> pages;
  for (const MemoryRange& one : all) {
    const auto begin = reinterpret_cast<uintptr_t>(one.place), end = begin + one.bytes;
    if (!uses_huge_pages(one.bytes)) continue;
    for (uintptr_t page = begin / kHugePage * kHugePage; page < end; page += kHugePage)
      pages.push_back(static_cast<char*>(one.place) + (std::max(page, begin) - begin));
  }
  parallel_for(pages.size(), [&](size_t i) { *pages[i] = 0; });
}

}  // namespace vug::lsystem
