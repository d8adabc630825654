// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/base/tsan_parallel.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace vug::detail {

void tsan_parallel_for(size_t count, size_t grain,
                       const std::function<void(size_t begin, size_t end)>& body) {
  static thread_local bool inside = false;
  if (inside) return body(0, count);

  std::atomic<size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&] {
    inside = true;
    try {
      for (size_t begin = next.fetch_add(grain); begin < count; begin = next.fetch_add(grain))
        body(begin, std::min(begin + grain, count));
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
      next = count;
    }
    inside = false;
  };
  std::vector<std::thread> threads(static_cast<size_t>(std::max(1, thread_count()) - 1));
  for (std::thread& thread : threads) thread = std::thread(work);
  work();
  for (std::thread& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace vug::detail
