// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/raytree/path_scheduler.h>
#include <vug/raytree/sanitizer_fiber.h>

#include <boost/context/fiber.hpp>
#include <boost/context/protected_fixedsize_stack.hpp>

#include <alloca.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <exception>
#include <numeric>
#include <vector>

namespace vug::raytree {
namespace {

namespace context = boost::context;

constexpr size_t kPaths = TraversalBatch::kCapacity;
/// Bytes of a path's stack, as large as those of TBB's threads: paints and fields may be nested
/// thousands of levels deep. Pages are touched only as needed, which pages of 2 MiB would defeat.
constexpr size_t kStackBytes = size_t{4} << 20;
/// Stacks begin at page boundaries. These offsets of their tops, in bytes, keep the tops from
/// competing for the same few sets of the first-level cache.
constexpr size_t kStackOffset = 4096 / kPaths + 64;

/// Free stacks of this thread, kept for reuse.
class StackPool {
 public:
  StackPool() = default;
  StackPool(const StackPool&) = delete;
  StackPool& operator=(const StackPool&) = delete;
  ~StackPool() {
    for (context::stack_context& stack : free_) system_.deallocate(stack);
  }
  context::stack_context acquire() {
    if (free_.empty()) {
      const context::stack_context stack = system_.allocate();
      madvise(static_cast<char*>(stack.sp) - stack.size, stack.size,
              MADV_NOHUGEPAGE);  // best effort
      return stack;
    }
    const context::stack_context stack = free_.back();
    free_.pop_back();
    return stack;
  }
  void release(const context::stack_context& stack) { free_.push_back(stack); }

 private:
  context::protected_fixedsize_stack system_{kStackBytes};
  std::vector<context::stack_context> free_;
};
thread_local StackPool stack_pool;

/// Stack allocator for Boost that returns stacks to the pool.
struct PoolAllocator {
  void deallocate(const context::stack_context& stack) { stack_pool.release(stack); }
};

/// A path with its stack, and the traversal that it waits for.
struct PathFiber {
  context::fiber path, home;
  BvhTraversal* traversal = nullptr;
  SanitizerFiber stack;
  SanitizerFiber* home_stack = nullptr;

  /// Suspends the path, on its own stack, until it is resumed.
  void wait() {
    stack.begin_switch_to(*home_stack);
    home = std::move(home).resume();
    stack.finish_switch_from(*home_stack);
  }
};
thread_local PathFiber* current = nullptr;  // the path whose stack is active

class Scheduler {
 public:
  Scheduler(size_t count, const std::function<void(size_t)>& work,
            const std::function<void(size_t)>& done)
      : count_(count), work_(work), done_(done) {}

  void run() {
    std::array<PathFiber, kPaths> fibers;
    TraversalBatch batch;
    size_t size = 0;
    for (PathFiber& fiber : fibers) {
      if (size == count_) break;
      prepare(fiber, kStackOffset * size++);
    }
    // Paths that wait for the results of others, and paths whose traversal has ended.
    std::vector<size_t> idle, ready(size);
    std::iota(ready.begin(), ready.end(), size_t{0});
    while (size > 0) {
      for (const size_t slot : ready) {
        PathFiber& fiber = fibers[slot];
        resume(fiber);
        if (!fiber.path)
          --size;
        else if (fiber.traversal)
          batch.add(slot, *fiber.traversal);
        else
          idle.push_back(slot);
      }
      const std::span<const uint8_t> ended = batch.step();
      ready.assign(ended.begin(), ended.end());
      ready.insert(ready.end(), idle.begin(), idle.end());
      idle.clear();
    }
    if (error_) std::rethrow_exception(error_);
  }

 private:
  void prepare(PathFiber& fiber, size_t offset) {
    const context::stack_context memory = stack_pool.acquire();
    fiber.stack.create(static_cast<char*>(memory.sp) - memory.size, memory.size);
    fiber.home_stack = &home_stack_;
    // Boost switches to the new stack and back.
    home_stack_.begin_switch_to(fiber.stack);
    fiber.stack.finish_switch_from(home_stack_);
    fiber.path =
        context::fiber(std::allocator_arg, context::preallocated(memory.sp, memory.size, memory),
                       PoolAllocator(), [this, &fiber, offset](context::fiber&& home) {
                         fiber.stack.finish_switch_from(home_stack_);
                         fiber.home = std::move(home);
                         static_cast<volatile char*>(alloca(offset + 1))[0] = 0;
                         run_jobs(fiber);
                         return std::move(fiber.home);
                       });
    fiber.stack.begin_switch_to(home_stack_);
    home_stack_.finish_switch_from(fiber.stack);
  }

  void resume(PathFiber& fiber) {
    fiber.traversal = nullptr;
    current = &fiber;
    home_stack_.begin_switch_to(fiber.stack);
    fiber.path = std::move(fiber.path).resume();
    const bool ended = !fiber.path;  // without an announced switch
    if (ended) fiber.stack.begin_switch_to(home_stack_, true);
    home_stack_.finish_switch_from(fiber.stack);
    if (ended) fiber.stack.destroy();
    current = nullptr;
  }

  /// Runs jobs on a path's stack until none are left.
  void run_jobs(PathFiber& fiber) {
    while (next_ < count_) {
      if (next_ - done_count_ >= kMaxInFlight) {
        fiber.wait();
        continue;
      }
      const size_t index = next_++;
      try {
        work_(index);
        returned_[index % kMaxInFlight] = true;
        while (done_count_ < next_ && returned_[done_count_ % kMaxInFlight]) {
          returned_[done_count_ % kMaxInFlight] = false;
          done_(done_count_++);
        }
      } catch (...) {
        if (!error_) error_ = std::current_exception();
        count_ = next_;
      }
    }
  }

  size_t count_;
  const std::function<void(size_t)>& work_;
  const std::function<void(size_t)>& done_;
  SanitizerFiber home_stack_;
  size_t next_ = 0, done_count_ = 0;  ///< The next job to start, and the first that is not done.
  std::array<bool, kMaxInFlight> returned_{};
  std::exception_ptr error_;
};

}  // namespace

void run_interleaved(size_t count, const std::function<void(size_t)>& work,
                     const std::function<void(size_t)>& done) {
  if (!current && count > 1) {
    Scheduler(count, work, done).run();
    return;
  }
  for (size_t i = 0; i < count; ++i) work(i), done(i);
}

void parallel_interleaved(size_t count, const std::function<void(size_t)>& work) {
  constexpr size_t kChunk = 256;
  parallel_for((count + kChunk - 1) / kChunk, [&](size_t chunk) {
    const size_t begin = chunk * kChunk;
    run_interleaved(
        std::min(count - begin, kChunk), [&](size_t i) { work(begin + i); }, [](size_t) {});
  });
}

void finish(BvhTraversal& traversal) {
  if (!current) return traversal.run();
  if (traversal.stage() == BvhTraversal::ended) return;
  current->traversal = &traversal;
  current->wait();
}

}  // namespace vug::raytree
