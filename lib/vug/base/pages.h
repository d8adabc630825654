// Memory of large arrays (see array.h).
#pragma once

#include <cstddef>

namespace vug {

inline constexpr size_t kLargePage = size_t{2} << 20;
/// Whether `pages_for` takes so much from the system.
inline bool has_pages(size_t bytes) { return bytes >= kLargePage / 2; }

/// Unset memory that begins at a line of the cache; Error(too_large) where there is none. From 1
/// MiB on it comes from the system in pages of 2 MiB, where they are to be had: who writes an array
/// for the first time would spend a third of its time on being given small ones, and who reads it
/// anywhere would wait for their addresses. What the heap gives may have been in use, in small
/// pages that stay so.
void* pages_for(size_t bytes);
void return_pages(void* place, size_t bytes);

}  // namespace vug
