// SPDX-License-Identifier: Apache-2.0
// Parallel loops and reductions on TBB with results that do not depend on the number of threads,
// and that number.
#pragma once

#include <vug/base/cancellable_scope.h>

#ifdef __SANITIZE_THREAD__
#include <vug/base/tsan_parallel.h>
#else
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

#include <cstddef>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace vug {

/// Calls body(i) for 0 <= i < count in tasks of about `grain` indices. The body must write only
/// data that belongs to its own index. Error(cancelled) in a CancellableScope.
template <class Body>
void parallel_for(size_t count, const Body& body, size_t grain = 1) {
  const auto task = [&, progress = CancellableScope::innermost()](size_t begin, size_t end) {
    const CancellableScope scope(progress);
    check_cancelled();
    for (size_t i = begin; i != end; ++i) body(i);
  };
#ifdef __SANITIZE_THREAD__
  detail::tsan_parallel_for(count, grain, task);
#else
  tbb::parallel_for(
      tbb::blocked_range<size_t>(0, count, grain),
      [&](const tbb::blocked_range<size_t>& range) { task(range.begin(), range.end()); });
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

namespace detail {
void run_with_threads(int threads, const std::function<void()>& work);
}

/// Runs `work` and returns its result; parallel loops in it use this number of threads, which may
/// exceed the number of cores. 0: one thread per core. A nested call can only reduce the number.
template <class Work>
auto with_threads(int threads, const Work& work) {
  using Result = std::invoke_result_t<Work>;
  if constexpr (std::is_void_v<Result>) {
    detail::run_with_threads(threads, work);
  } else {
    std::optional<Result> result;
    detail::run_with_threads(threads, [&] { result.emplace(work()); });
    return std::move(*result);
  }
}

/// The number of threads that parallel loops use now.
int thread_count();

}  // namespace vug
