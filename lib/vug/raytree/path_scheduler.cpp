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

namespace vug::render {
namespace {

namespace context = boost::context;

constexpr size_t kPaths = RayBatch::kMost;
/// As deep as those of TBB's threads: paints and fields may lie in each other some thousand times.
/// Touched as far as it is needed only, which pages of 2 MiB would defeat.
constexpr size_t kStack = size_t{4} << 20;
/// Stacks begin at pages; so far apart within one, the tops of all do not fight for the same few
/// places of the first cache.
constexpr size_t kApart = 4096 / kPaths + 64;

/// Stacks of this thread that are kept for the next to use.
class Stacks {
 public:
  Stacks() = default;
  Stacks(const Stacks&) = delete;
  Stacks& operator=(const Stacks&) = delete;
  ~Stacks() {
    for (context::stack_context& stack : free_) system_.deallocate(stack);
  }
  context::stack_context take() {
    if (free_.empty()) {
      const context::stack_context made = system_.allocate();
      madvise(static_cast<char*>(made.sp) - made.size, made.size, MADV_NOHUGEPAGE);  // a wish
      return made;
    }
    const context::stack_context stack = free_.back();
    free_.pop_back();
    return stack;
  }
  void give_back(const context::stack_context& stack) { free_.push_back(stack); }

 private:
  context::protected_fixedsize_stack system_{kStack};
  std::vector<context::stack_context> free_;
};
thread_local Stacks stacks;

/// What boost gives a stack back to.
struct KeptStacks {
  void deallocate(const context::stack_context& stack) { stacks.give_back(stack); }
};

/// One path's stack, and what it waits for.
struct Lane {
  context::fiber path, home;
  RaySearch* search = nullptr;
  WatchedStack stack;
  WatchedStack* home_stack = nullptr;

  /// Called on the path's stack: back to the one that it was resumed from, until it is again.
  void wait() {
    stack.leave_for(*home_stack);
    home = std::move(home).resume();
    stack.arrive_from(*home_stack);
  }
};
thread_local Lane* current = nullptr;  // whose stack this is

class Team {
 public:
  Team(size_t count, const std::function<void(size_t)>& work,
       const std::function<void(size_t)>& done)
      : count_(count), work_(work), done_(done) {}

  void go() {
    std::array<Lane, kPaths> lanes;
    RayBatch batch;
    size_t size = 0;
    for (Lane& lane : lanes) {
      if (size == count_) break;
      prepare(lane, kApart * size++);
    }
    // Those that wait for others' results, and those whose search has come to its end.
    std::vector<size_t> idle, back(size);
    std::iota(back.begin(), back.end(), size_t{0});
    while (size > 0) {
      for (const size_t slot : back) {
        Lane& lane = lanes[slot];
        resume(lane);
        if (!lane.path)
          --size;
        else if (lane.search)
          batch.add(slot, *lane.search);
        else
          idle.push_back(slot);
      }
      const std::span<const uint8_t> ended = batch.step();
      back.assign(ended.begin(), ended.end());
      back.insert(back.end(), idle.begin(), idle.end());
      idle.clear();
    }
    if (error_) std::rethrow_exception(error_);
  }

 private:
  void prepare(Lane& lane, size_t apart) {
    const context::stack_context memory = stacks.take();
    lane.stack.begin(static_cast<char*>(memory.sp) - memory.size, memory.size);
    lane.home_stack = &home_stack_;
    // Boost goes over to the new stack and back.
    home_stack_.leave_for(lane.stack);
    lane.stack.arrive_from(home_stack_);
    lane.path =
        context::fiber(std::allocator_arg, context::preallocated(memory.sp, memory.size, memory),
                       KeptStacks(), [this, &lane, apart](context::fiber&& home) {
                         lane.stack.arrive_from(home_stack_);
                         lane.home = std::move(home);
                         static_cast<volatile char*>(alloca(apart + 1))[0] = 0;
                         take_turns(lane);
                         return std::move(lane.home);
                       });
    lane.stack.leave_for(home_stack_);
    home_stack_.arrive_from(lane.stack);
  }

  void resume(Lane& lane) {
    lane.search = nullptr;
    current = &lane;
    home_stack_.leave_for(lane.stack);
    lane.path = std::move(lane.path).resume();
    const bool ended = !lane.path;  // and did not say that it left
    if (ended) lane.stack.leave_for(home_stack_, true);
    home_stack_.arrive_from(lane.stack);
    if (ended) lane.stack.end();
    current = nullptr;
  }

  /// On a path's stack.
  void take_turns(Lane& lane) {
    while (next_ < count_) {
      if (next_ - begun_ >= kMostAhead) {
        lane.wait();
        continue;
      }
      const size_t index = next_++;
      try {
        work_(index);
        back_[index % kMostAhead] = true;
        while (begun_ < next_ && back_[begun_ % kMostAhead]) {
          back_[begun_ % kMostAhead] = false;
          done_(begun_++);
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
  WatchedStack home_stack_;
  size_t next_ = 0, begun_ = 0;  ///< The next to begin, and the first that is not done.
  std::array<bool, kMostAhead> back_{};
  std::exception_ptr error_;
};

}  // namespace

void work_together(size_t count, const std::function<void(size_t)>& work,
                   const std::function<void(size_t)>& done) {
  if (!current && count > 1) {
    Team(count, work, done).go();
    return;
  }
  for (size_t i = 0; i < count; ++i) work(i), done(i);
}

void parallel_together(size_t count, const std::function<void(size_t)>& work) {
  constexpr size_t kChunk = 256;
  parallel_for((count + kChunk - 1) / kChunk, [&](size_t chunk) {
    const size_t begin = chunk * kChunk;
    work_together(
        std::min(count - begin, kChunk), [&](size_t i) { work(begin + i); }, [](size_t) {});
  });
}

void finish(RaySearch& search) {
  if (!current) return search.go();
  if (search.stage() == RaySearch::ended) return;
  current->search = &search;
  current->wait();
}

}  // namespace vug::render
