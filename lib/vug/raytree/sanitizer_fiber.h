// What sanitizers are told when a thread changes stacks. Without them all of it is nothing.
#pragma once

#include <cstddef>

#if defined(__has_feature)
#define VUG_HAS_FEATURE(name) __has_feature(name)
#else
#define VUG_HAS_FEATURE(name) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || VUG_HAS_FEATURE(address_sanitizer)
#define VUG_WATCHES_ADDRESSES 1
#include <sanitizer/common_interface_defs.h>
#endif
#if defined(__SANITIZE_THREAD__) || VUG_HAS_FEATURE(thread_sanitizer)
#define VUG_WATCHES_THREADS 1
#include <sanitizer/tsan_interface.h>
#endif
#undef VUG_HAS_FEATURE

namespace vug::render {

/// A stack as sanitizers know it: the address sanitizer by where it lies, so that an exception
/// clears what it poisoned there; the thread sanitizer as a thread of its own that runs when told.
class WatchedStack {
 public:
  /// The one that this thread is on, once it is left for another.
  WatchedStack() = default;
  WatchedStack(const WatchedStack&) = delete;
  WatchedStack& operator=(const WatchedStack&) = delete;

  /// Memory for another that begins at its least address. To be called on the one that is left for
  /// it, as `end` is when nothing will run on it any more.
  void begin([[maybe_unused]] const void* least, [[maybe_unused]] size_t bytes) {
#if VUG_WATCHES_ADDRESSES
    least_ = least, bytes_ = bytes;
#endif
#if VUG_WATCHES_THREADS
    fiber_ = __tsan_create_fiber(0);
#endif
  }
  void end() {
#if VUG_WATCHES_THREADS
    __tsan_destroy_fiber(fiber_);
#endif
  }

  /// Just before this thread goes on upon another stack. This one is left for good when there is
  /// nothing to come back to.
  void leave_for([[maybe_unused]] WatchedStack& other, [[maybe_unused]] bool for_good = false) {
#if VUG_WATCHES_ADDRESSES
    __sanitizer_start_switch_fiber(for_good ? nullptr : &aside_, other.least_, other.bytes_);
#endif
#if VUG_WATCHES_THREADS
    if (!fiber_) fiber_ = __tsan_get_current_fiber();
    __tsan_switch_to_fiber(other.fiber_, 0);
#endif
  }
  /// The first that it does there, where it came from `other`.
  void arrive_from([[maybe_unused]] WatchedStack& other) {
#if VUG_WATCHES_ADDRESSES
    __sanitizer_finish_switch_fiber(aside_, &other.least_, &other.bytes_);
#endif
  }

 private:
#if VUG_WATCHES_ADDRESSES
  const void* least_ = nullptr;
  size_t bytes_ = 0;
  void* aside_ = nullptr;  ///< Where locals are kept that may be used after they are gone.
#endif
#if VUG_WATCHES_THREADS
  void* fiber_ = nullptr;
#endif
};

}  // namespace vug::render
