// Parallel loops on plain threads, for builds with ThreadSanitizer only: TBB comes without its
// instrumentation, so that every hand-over through it looks like a race, and hiding those would
// hide ours. See tests/sanitizers/tsan.supp.
#pragma once

#include <cstddef>
#include <functional>

namespace vug::detail {

/// body(begin, end) for chunks of 0..count of `grain` indices, on thread_count() threads. Loops
/// inside of loops run on the calling thread. The first exception is thrown again at the end.
void plain_parallel_for(size_t count, size_t grain,
                        const std::function<void(size_t begin, size_t end)>& body);

}  // namespace vug::detail
