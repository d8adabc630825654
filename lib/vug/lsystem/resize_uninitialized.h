// SPDX-License-Identifier: Apache-2.0
// Resizing of the buffers of words with spare capacity for the next steps.
#pragma once

#include <vug/base/uninitialized_vector.h>

#include <algorithm>

namespace vug::lsystem {

/// Resizes the array without initializing it: a step writes every element, on the thread that the
/// memory should be local to. Reserves capacity for the next steps as well: the system provides
/// large blocks page by page on first write (base/huge_pages.h), and reused pages need not be
/// cleared again.
template <class T>
void resize_uninitialized(UninitializedVector<T>& array, size_t size) {
  constexpr size_t kLarge = (size_t{1} << 20) / sizeof(T), kMaxInFlight = 256 * kLarge;
  array.clear();  // no elements to move
  if (size > array.capacity())
    array.reserve(size + std::min((size < kLarge ? 2 : 30) * size, kMaxInFlight));
  array.resize(size);
}

}  // namespace vug::lsystem
