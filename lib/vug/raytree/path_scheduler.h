// SPDX-License-Identifier: Apache-2.0
// Scheduler that interleaves the paths of one thread to hide memory latency: while the memory for
// one path's ray is fetched, other paths continue.
#pragma once

#include <vug/raytree/bvh_traversal.h>

#include <cstddef>
#include <functional>

namespace vug::raytree {

/// Calls work(i) for 0 <= i < count, several at a time on this thread, each on a stack of its own;
/// the thread switches between them only in `finish`. Calls done(i) in the order of i, one at a
/// time, once work(0) to work(i) have returned; `done` must trace no rays. The results are those of
/// a loop over work(i) and done(i). An exception is rethrown after the other calls that had started
/// have returned.
void run_interleaved(size_t count, const std::function<void(size_t)>& work,
                     const std::function<void(size_t)>& done);
/// Limit of how far work runs ahead of done: work(i) may keep its results at i % kMaxInFlight.
constexpr size_t kMaxInFlight = 64;

/// Calls work(i) for 0 <= i < count on all threads, several at a time on each; each call must write
/// only to data of its own index.
void parallel_interleaved(size_t count, const std::function<void(size_t)>& work);

/// Runs the traversal to its end. Within run_interleaved, other paths advance meanwhile.
void finish(BvhTraversal& traversal);

}  // namespace vug::raytree
