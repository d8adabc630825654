// Vectors that do not fill what they are about to be overwritten with.
#pragma once

#include <vug/base/pages.h>

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace vug {

/// As std::allocator, but of pages (see pages.h), and `resize` leaves what is new unset.
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

}  // namespace vug
