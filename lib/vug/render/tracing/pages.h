// Memory in pages of 2 MiB, where there is enough of it: rays that go anywhere would else wait for
// the addresses of pages, too.
#pragma once

#include <cstddef>
#include <memory>

namespace vug::render {

struct Unmap {
  void* begin = nullptr;
  size_t bytes = 0;
  void operator()(void*) const;
};
template <class T>
using Pages = std::unique_ptr<T[], Unmap>;

/// Of zeros. Throws Error(too_large) where there is no such memory.
std::unique_ptr<void, Unmap> map_pages(size_t bytes);

/// For plain types, which zeros are a value of.
template <class T>
Pages<T> pages(size_t count) {
  std::unique_ptr<void, Unmap> memory = map_pages(count * sizeof(T));
  const Unmap unmap = memory.get_deleter();
  return Pages<T>(static_cast<T*>(memory.release()), unmap);
}

}  // namespace vug::render
