// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/huge_pages.h>
#include <vug/base/memory.h>

#include <sys/mman.h>

#include <cstdint>
#include <new>

namespace vug {
namespace {

constexpr std::align_val_t kLine{64};

size_t whole(size_t bytes) { return (bytes + kHugePage - 1) / kHugePage * kHugePage; }

}  // namespace

void* allocate_array(size_t bytes) {
  if (!uses_huge_pages(bytes)) return ::operator new(bytes, kLine);
  // Huge pages start at multiples of their size: map one more and unmap the excess.
  const size_t size = whole(bytes);
  void* const given = mmap(nullptr, size + kHugePage, PROT_READ | PROT_WRITE,
                           MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (given == MAP_FAILED)
    throw Error(ErrorCode::too_large,
                "cannot allocate " + bytes_text(static_cast<double>(bytes)) + " for an array");
  char* const begin = static_cast<char*>(given);
  const size_t before =
      whole(reinterpret_cast<uintptr_t>(begin)) - reinterpret_cast<uintptr_t>(begin);
  if (before > 0) munmap(begin, before);
  munmap(begin + before + size, kHugePage - before);
  madvise(begin + before, size, MADV_HUGEPAGE);  // a hint: failure only affects speed
  return begin + before;
}

void free_array(void* place, size_t bytes) {
  if (uses_huge_pages(bytes))
    munmap(place, whole(bytes));
  else
    ::operator delete(place, kLine);
}

}  // namespace vug
