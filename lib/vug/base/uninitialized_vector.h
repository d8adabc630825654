// SPDX-License-Identifier: Apache-2.0
// std::vector variant whose new elements stay uninitialized, for arrays that are overwritten at
// once.
#pragma once

#include <vug/base/huge_pages.h>

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace vug {

/// Like std::allocator, but allocates with allocate_array (huge_pages.h) and default-initializes
/// new elements, so `resize` leaves them unset.
template <class T>
struct UninitializedAllocator : std::allocator<T> {
  static_assert(std::is_trivially_default_constructible_v<T>);
  template <class U>
  struct rebind {  // NOLINT(readability-identifier-naming): the standard's name
    using other = UninitializedAllocator<U>;
  };
  T* allocate(size_t count) { return static_cast<T*>(allocate_array(count * sizeof(T))); }
  void deallocate(T* place, size_t count) { free_array(place, count * sizeof(T)); }
  template <class U, class... Args>
  void construct(U* place, Args&&... args) {
    if constexpr (sizeof...(args) == 0)
      ::new (static_cast<void*>(place)) U;
    else
      ::new (static_cast<void*>(place)) U(std::forward<Args>(args)...);
  }
};

template <class T>
using UninitializedVector = std::vector<T, UninitializedAllocator<T>>;

}  // namespace vug
