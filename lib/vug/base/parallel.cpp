// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>

#include <tbb/global_control.h>
#include <tbb/info.h>

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

}  // namespace

struct ThreadLimit::Control {
  explicit Control(int threads) : before(limit.exchange(threads)) {}
  ~Control() { limit = before; }
  int before;
};

int thread_count() {
  const int threads = limit;
  return threads > 0 ? threads : all_cores();
}

#else

struct ThreadLimit::Control {
  explicit Control(int threads)
      : limit(global_control::max_allowed_parallelism,
              static_cast<size_t>(threads > 0 ? threads : all_cores())) {}
  global_control limit;
};

int thread_count() {
  return static_cast<int>(global_control::active_value(global_control::max_allowed_parallelism));
}

#endif

ThreadLimit::ThreadLimit(int threads) : control_(std::make_unique<Control>(threads)) {}

ThreadLimit::~ThreadLimit() = default;

}  // namespace vug
