#include <vug/base/error.h>
#include <vug/base/memory.h>
#include <vug/base/parallel.h>
#include <vug/lsystem/clear_pages.h>
#include <vug/lsystem/pages.h>

#include <sys/mman.h>

#include <algorithm>
#include <cstdint>
#include <new>
#include <vector>

namespace vug::lsystem {

namespace {

constexpr size_t kPage = size_t{2} << 20;

bool is_large(size_t bytes) { return bytes >= kPage / 2; }

size_t whole(size_t bytes) { return (bytes + kPage - 1) / kPage * kPage; }

}  // namespace

void* pages_for(size_t bytes) {
  if (!is_large(bytes)) return ::operator new(bytes);
  // Large pages begin at their multiples: one more is asked for, what is too much goes back.
  const size_t size = whole(bytes);
  void* const given = mmap(nullptr, size + kPage, PROT_READ | PROT_WRITE,
                           MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (given == MAP_FAILED)
    throw Error(ErrorCode::too_large,
                "no memory for " + bytes_text(static_cast<double>(bytes)) + " of a word");
  char* const begin = static_cast<char*>(given);
  const size_t before =
      whole(reinterpret_cast<uintptr_t>(begin)) - reinterpret_cast<uintptr_t>(begin);
  if (before > 0) munmap(begin, before);
  munmap(begin + before + size, kPage - before);
  madvise(begin + before, size, MADV_HUGEPAGE);  // a wish: without it all is as right, but slower
  return begin + before;
}

void return_pages(void* place, size_t bytes) {
  if (is_large(bytes))
    munmap(place, whole(bytes));
  else
    ::operator delete(place);
}

void clear_pages(std::initializer_list<Memory> all) {
  std::vector<volatile char*> pages;
  for (const Memory& one : all) {
    const auto begin = reinterpret_cast<uintptr_t>(one.place), end = begin + one.bytes;
    if (!is_large(one.bytes)) continue;
    for (uintptr_t page = begin / kPage * kPage; page < end; page += kPage)
      pages.push_back(static_cast<char*>(one.place) + (std::max(page, begin) - begin));
  }
  parallel_for(pages.size(), [&](size_t i) { *pages[i] = 0; });
}

}  // namespace vug::lsystem
