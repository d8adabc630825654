// Sorting on many threads.
#pragma once

#ifdef __SANITIZE_THREAD__
#include <algorithm>
#else
#include <tbb/parallel_sort.h>
#endif

namespace vug {

/// Sorts by `<`. Not stable: what must not depend on the number of threads has no equal elements,
/// e.g. carries its index. Under the thread sanitizer, which cannot look into TBB, one thread
/// sorts.
template <class Iterator>
void parallel_sort(Iterator begin, Iterator end) {
#ifdef __SANITIZE_THREAD__
  std::sort(begin, end);
#else
  tbb::parallel_sort(begin, end);
#endif
}

}  // namespace vug
