#include <vug/base/parallel.h>

#include <tbb/global_control.h>
#include <tbb/info.h>

namespace vug {

struct ThreadLimit::Control {
  tbb::global_control limit;
};

ThreadLimit::ThreadLimit(int threads)
    : control_(new Control{tbb::global_control(
          tbb::global_control::max_allowed_parallelism,
          threads > 0 ? static_cast<size_t>(threads)
                      : static_cast<size_t>(tbb::info::default_concurrency()))}) {}

ThreadLimit::~ThreadLimit() = default;

int thread_count() {
  return static_cast<int>(
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

}  // namespace vug
