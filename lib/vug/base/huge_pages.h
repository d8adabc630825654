// SPDX-License-Identifier: Apache-2.0
// Memory for large arrays, backed by huge pages (see uninitialized_vector.h).
#pragma once

#include <cstddef>

namespace vug {

inline constexpr size_t kHugePage = size_t{2} << 20;
/// Whether `allocate_array` maps a block of that size directly from the system.
inline bool uses_huge_pages(size_t bytes) { return bytes >= kHugePage / 2; }

/// Uninitialized memory, aligned to a cache line. Throws Error(too_large) if there is not enough.
/// Blocks from 1 MiB on are mapped from the system in pages of 2 MiB if available: with small
/// pages, the first write of an array would spend a third of its time on page faults, and random
/// reads would wait for address translation. Blocks of the heap may be recycled and keep their
/// small pages.
void* allocate_array(size_t bytes);
void free_array(void* place, size_t bytes);

}  // namespace vug
