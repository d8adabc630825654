// Vectors that do not fill what they are about to be overwritten with.
#pragma once

#include <vug/lsystem/pages.h>

#include <algorithm>
#include <memory>
#include <type_traits>
#include <vector>

namespace vug::lsystem {

/// As std::allocator, but `resize` leaves new numbers unset: a step writes each of them, on the
/// thread that the memory should be near.
template <class T>
struct UnsetAllocator : std::allocator<T> {
  static_assert(std::is_trivially_default_constructible_v<T>);
  template <class U>
  struct rebind {  // NOLINT(readability-identifier-naming): the standard's name
    using other = UnsetAllocator<U>;
  };
  T* allocate(size_t count) { return static_cast<T*>(pages_for(count * sizeof(T))); }
  void deallocate(T* place, size_t count) { return_pages(place, count * sizeof(T)); }
  template <class U, class... Args>
  void construct(U* place, Args&&... args) {
    if constexpr (sizeof...(args) == 0)
      ::new (static_cast<void*>(place)) U;
    else
      ::new (static_cast<void*>(place)) U(std::forward<Args>(args)...);
  }
};

template <class T>
using Array = std::vector<T, UnsetAllocator<T>>;

/// As many numbers of unset content. Asks for room in which those of the next steps fit as well:
/// the system gives large memory page by page, as it is written to (pages.h), and what has been
/// given once need not be cleared again.
template <class T>
void resize_unset(Array<T>& array, size_t size) {
  constexpr size_t kLarge = (size_t{1} << 20) / sizeof(T), kMostAhead = 256 * kLarge;
  array.clear();  // nothing is to be carried along
  if (size > array.capacity())
    array.reserve(size + std::min((size < kLarge ? 2 : 30) * size, kMostAhead));
  array.resize(size);
}

}  // namespace vug::lsystem
