// SPDX-License-Identifier: Apache-2.0
// Announces stack switches of a thread to sanitizers. Without sanitizers all of it is empty.
#pragma once

#include <cstddef>

#if defined(__has_feature)
#define VUG_HAS_FEATURE(name) __has_feature(name)
#else
#define VUG_HAS_FEATURE(name) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || VUG_HAS_FEATURE(address_sanitizer)
#define VUG_HAS_ASAN 1
#include <sanitizer/common_interface_defs.h>
#endif
#if defined(__SANITIZE_THREAD__) || VUG_HAS_FEATURE(thread_sanitizer)
#define VUG_HAS_TSAN 1
#include <sanitizer/tsan_interface.h>

#include <mutex>
#include <vector>
#endif
#undef VUG_HAS_FEATURE

namespace vug::raytree {

/// A stack as sanitizers know it. The address sanitizer needs its range, so that an exception
/// unpoisons the frames that it unwinds; the thread sanitizer treats it as a thread of its own that
/// runs when it is switched to.
class SanitizerFiber {
 public:
  /// The thread's current stack, from the first switch away from it.
  SanitizerFiber() = default;
  SanitizerFiber(const SanitizerFiber&) = delete;
  SanitizerFiber& operator=(const SanitizerFiber&) = delete;

  /// Describes a new stack by its lowest address and its size. Call this on the stack from which
  /// the thread will switch to it, as well as `destroy` once nothing will run on it any more.
  void create([[maybe_unused]] const void* lowest, [[maybe_unused]] size_t bytes) {
#if VUG_HAS_ASAN
    lowest_ = lowest, bytes_ = bytes;
#endif
#if VUG_HAS_TSAN
    fiber_ = Pool::get().take();
#endif
  }
  void destroy() {
#if VUG_HAS_TSAN
    Pool::get().give_back(fiber_);
#endif
  }

  /// Call this just before the thread switches to another stack; `is_final`: it will not return to
  /// this one.
  void begin_switch_to([[maybe_unused]] SanitizerFiber& other,
                       [[maybe_unused]] bool is_final = false) {
#if VUG_HAS_ASAN
    __sanitizer_start_switch_fiber(is_final ? nullptr : &fake_stack_, other.lowest_, other.bytes_);
#endif
#if VUG_HAS_TSAN
    if (!fiber_) fiber_ = __tsan_get_current_fiber();
    __tsan_switch_to_fiber(other.fiber_, 0);
#endif
  }
  /// Call this first on the new stack, to which the thread switched from `other`.
  void finish_switch_from([[maybe_unused]] SanitizerFiber& other) {
#if VUG_HAS_ASAN
    __sanitizer_finish_switch_fiber(fake_stack_, &other.lowest_, &other.bytes_);
#endif
  }

 private:
#if VUG_HAS_ASAN
  const void* lowest_ = nullptr;
  size_t bytes_ = 0;
  void* fake_stack_ = nullptr;  ///< Holds locals for the detection of use after return.
#endif
#if VUG_HAS_TSAN
  /// Finished fibers for the next stacks: each takes megabytes to create, and a picture has
  /// thousands.
  class Pool {
   public:
    static Pool& get() {
      static Pool pool;
      return pool;
    }
    void* take() {
      const std::lock_guard lock(mutex_);
      if (free_.empty()) return __tsan_create_fiber(0);
      void* fiber = free_.back();
      free_.pop_back();
      return fiber;
    }
    void give_back(void* fiber) {
      const std::lock_guard lock(mutex_);
      free_.push_back(fiber);
    }

   private:
    std::mutex mutex_;
    std::vector<void*> free_;
  };
  void* fiber_ = nullptr;
#endif
};

}  // namespace vug::raytree
