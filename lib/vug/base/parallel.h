// SPDX-License-Identifier: Apache-2.0
// Parallel loops and reductions on TBB with results that do not depend on the number of threads.
#pragma once

#ifdef __SANITIZE_THREAD__
#include <vug/base/tsan_parallel.h>
#else
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

#include <cstddef>
#include <memory>
#include <vector>

namespace vug {

/// Calls body(i) for 0 <= i < count in tasks of about `grain` indices. The body must write only
/// data that belongs to its own index.
template <class Body>
void parallel_for(size_t count, const Body& body, size_t grain = 1) {
#ifdef __SANITIZE_THREAD__
  detail::tsan_parallel_for(count, grain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i != end; ++i) body(i);
  });
#else
  tbb::parallel_for(tbb::blocked_range<size_t>(0, count, grain),
                    [&](const tbb::blocked_range<size_t>& range) {
                      for (size_t i = range.begin(); i != range.end(); ++i) body(i);
                    });
#endif
}

/// Reduces term(i) over 0 <= i < count in fixed chunks in index order, each starting with `zero`;
/// the result is bit-identical for any number of threads. join(a, b) combines two values.
template <class Value, class Term, class Join>
Value ordered_reduce(size_t count, Value zero, const Term& term, const Join& join,
                     size_t chunk = 4096) {
  std::vector<Value> parts((count + chunk - 1) / chunk, zero);
  parallel_for(parts.size(), [&](size_t part) {
    const size_t end = count < (part + 1) * chunk ? count : (part + 1) * chunk;
    Value value = zero;
    for (size_t i = part * chunk; i < end; ++i) value = join(value, term(i));
    parts[part] = value;
  });
  Value total = zero;
  for (const Value& part : parts) total = join(total, part);
  return total;
}

/// The sum of term(i) over 0 <= i < count, by ordered_reduce.
template <class Sum, class Term>
Sum ordered_sum(size_t count, Sum zero, const Term& term, size_t chunk = 4096) {
  return ordered_reduce(
      count, zero, term, [](const Sum& a, const auto& b) { return static_cast<Sum>(a + b); },
      chunk);
}

/// Limits the number of threads during its lifetime; 0 means all cores. The limit may exceed the
/// number of cores.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct Control;
  std::unique_ptr<Control> control_;
};

/// The number of threads that parallel loops use now.
int thread_count();

}  // namespace vug
