// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <atomic>

namespace vug {
namespace {

using tbb::global_control;

int all_cores() { return tbb::info::default_concurrency(); }

}  // namespace

#ifdef __SANITIZE_THREAD__

namespace {

/// Tasks of external libraries stay on the calling thread, because the sanitizer cannot follow the
/// synchronization of TBB, which is not instrumented. Own loops run on plain threads.
const global_control no_workers(global_control::max_allowed_parallelism, 1);

std::atomic<int> limit{0};  // 0: none

/// Sets the limit during its lifetime.
struct ThreadLimit {
  explicit ThreadLimit(int threads) : before(limit.exchange(threads)) {}
  ~ThreadLimit() { limit = before; }
  int before;
};

}  // namespace

void detail::run_with_threads(int threads, const std::function<void()>& work) {
  const ThreadLimit own(threads);
  work();
}

int thread_count() {
  const int threads = limit;
  return threads > 0 ? threads : all_cores();
}

#else

void detail::run_with_threads(int threads, const std::function<void()>& work) {
  const int wanted = threads > 0 ? threads : all_cores();
  const global_control limit(global_control::max_allowed_parallelism, static_cast<size_t>(wanted));
  // An arena of its own, because the implicit one never has more threads than there are cores.
  tbb::task_arena arena(thread_count());
  arena.execute([&] { work(); });
}

int thread_count() {
  return static_cast<int>(global_control::active_value(global_control::max_allowed_parallelism));
}

#endif

}  // namespace vug
