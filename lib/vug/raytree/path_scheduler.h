// Paths of one thread that wait together: while memory fetches what one ray needs, others go on.
#pragma once

#include <vug/raytree/bvh_traversal.h>

#include <cstddef>
#include <functional>

namespace vug::render {

/// Calls work(i) for 0 <= i < count, several at a time on this thread, each with a stack of its
/// own; they change only in `finish`. Calls done(i) in the order of i, when all before have come
/// back, one at a time; `done` must look for no rays. Results are those of a loop over work(i) and
/// done(i). What they throw is thrown, when the others that had begun have come back.
void work_together(size_t count, const std::function<void(size_t)>& work,
                   const std::function<void(size_t)>& done);
/// So far may work be ahead of what is done: work(i) may keep its results at i % kMostAhead.
constexpr size_t kMostAhead = 64;

/// Calls work(i) for 0 <= i < count on all threads, several at a time on each; each must write only
/// what belongs to its own index.
void parallel_together(size_t count, const std::function<void(size_t)>& work);

/// Goes on with the search to its end. Within work_together others go on with theirs meanwhile.
void finish(RaySearch& search);

}  // namespace vug::render
