#include <vug/base/parallel.h>
#include <vug/render/tracing/together.h>

#include <boost/context/fiber.hpp>
#include <boost/context/protected_fixedsize_stack.hpp>

#include <alloca.h>

#include <algorithm>
#include <array>
#include <exception>
#include <numeric>
#include <vector>

namespace vug::render {
namespace {

// Sanitizers know nothing of stacks that change.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kTogether = false;
#elif defined(__has_feature)
constexpr bool kTogether = !__has_feature(address_sanitizer) && !__has_feature(thread_sanitizer);
#else
constexpr bool kTogether = true;
#endif

namespace context = boost::context;

constexpr size_t kPaths = RayBatch::kMost;
/// Touched as far as it is needed only.
constexpr size_t kStack = size_t{512} << 10;
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
    if (free_.empty()) return system_.allocate();
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

/// What boost asks for stacks.
struct KeptStacks {
  context::stack_context allocate() { return stacks.take(); }
  void deallocate(const context::stack_context& stack) { stacks.give_back(stack); }
};

/// One path's stack, and what it waits for.
struct Lane {
  context::fiber path, home;
  RaySearch* search = nullptr;
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
      const size_t apart = kApart * size;
      lane.path = context::fiber(std::allocator_arg, KeptStacks(),
                                 [this, &lane, apart](context::fiber&& home) {
                                   lane.home = std::move(home);
                                   static_cast<volatile char*>(alloca(apart + 1))[0] = 0;
                                   take_turns(lane);
                                   return std::move(lane.home);
                                 });
      ++size;
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
  static void resume(Lane& lane) {
    lane.search = nullptr;
    current = &lane;
    lane.path = std::move(lane.path).resume();
    current = nullptr;
  }

  /// On a path's stack.
  void take_turns(Lane& lane) {
    while (next_ < count_) {
      if (next_ - begun_ >= kMostAhead) {
        lane.home = std::move(lane.home).resume();
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
  size_t next_ = 0, begun_ = 0;  ///< The next to begin, and the first that is not done.
  std::array<bool, kMostAhead> back_{};
  std::exception_ptr error_;
};

}  // namespace

void work_together(size_t count, const std::function<void(size_t)>& work,
                   const std::function<void(size_t)>& done) {
  if (kTogether && !current && count > 1) {
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
  current->home = std::move(current->home).resume();
}

}  // namespace vug::render
