// Room for the words of steps to come.
#pragma once

#include <vug/base/uninitialized_vector.h>

#include <algorithm>

namespace vug::lsystem {

/// As many numbers of unset content: a step writes each of them, on the thread that the memory
/// should be near. Asks for room in which those of the next steps fit as well: the system gives
/// large memory page by page, as it is written to (base/huge_pages.h), and what has been given once
/// need not be cleared again.
template <class T>
void resize_uninitialized(UninitializedVector<T>& array, size_t size) {
  constexpr size_t kLarge = (size_t{1} << 20) / sizeof(T), kMaxInFlight = 256 * kLarge;
  array.clear();  // nothing is to be carried along
  if (size > array.capacity())
    array.reserve(size + std::min((size < kLarge ? 2 : 30) * size, kMaxInFlight));
  array.resize(size);
}

}  // namespace vug::lsystem
