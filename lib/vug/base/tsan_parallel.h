// SPDX-License-Identifier: Apache-2.0
// Parallel loops on plain threads, for builds with ThreadSanitizer only. TBB is not instrumented,
// so every synchronization through it looks like a race, and suppressing those reports would also
// hide races of this library. See tests/sanitizers/tsan.supp.
#pragma once

#include <cstddef>
#include <functional>

namespace vug::detail {

/// Calls body(begin, end) for chunks of `grain` indices of 0..count on thread_count() threads.
/// Nested loops run on the calling thread. The first exception is rethrown at the end.
void tsan_parallel_for(size_t count, size_t grain,
                       const std::function<void(size_t begin, size_t end)>& body);

}  // namespace vug::detail
