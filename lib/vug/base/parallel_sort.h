// SPDX-License-Identifier: Apache-2.0
// Parallel sorting.
#pragma once

#ifdef __SANITIZE_THREAD__
#include <algorithm>
#else
#include <tbb/parallel_sort.h>
#endif

namespace vug {

/// Sorts by `<`. Not stable: for results that do not depend on the number of threads, elements must
/// be distinct, e.g. contain their index. Runs on one thread under ThreadSanitizer, because TBB is
/// not instrumented.
template <class Iterator>
void parallel_sort(Iterator begin, Iterator end) {
#ifdef __SANITIZE_THREAD__
  std::sort(begin, end);
#else
  tbb::parallel_sort(begin, end);
#endif
}

}  // namespace vug
