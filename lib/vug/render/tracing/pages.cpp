#include <vug/base/error.h>
#include <vug/render/tracing/pages.h>

#include <fmt/format.h>
#include <sys/mman.h>

#include <cstdint>

namespace vug::render {

void Unmap::operator()(void*) const { munmap(begin, bytes); }

std::unique_ptr<void, Unmap> map_pages(size_t bytes) {
  constexpr size_t kPage = size_t{2} << 20;
  const bool large = bytes >= kPage;
  // Not of the heap: it may give memory that has been in use, whose pages are small and stay so.
  const size_t all = large ? (bytes + kPage - 1) / kPage * kPage + kPage : bytes;
  void* const begin = mmap(nullptr, all, PROT_READ | PROT_WRITE,
                           MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (begin == MAP_FAILED)
    throw Error(ErrorCode::too_large,
                fmt::format("no memory for {} MiB of rays' trees", all >> 20));
  std::unique_ptr<void, Unmap> out(begin, Unmap{begin, all});
  if (!large) return out;
  const auto address = reinterpret_cast<uintptr_t>(begin);
  char* const page = static_cast<char*>(begin) + ((address + kPage - 1) / kPage * kPage - address);
  madvise(page, all - kPage, MADV_HUGEPAGE);  // a wish
  out.release();
  return {page, Unmap{begin, all}};
}

}  // namespace vug::render
