// SPDX-License-Identifier: Apache-2.0
// Working memory for batch evaluation: a stack of aligned arrays, one per thread.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace vug::field {

/// Arrays are allocated while a Frame exists and released together when it ends. The memory is
/// reused, so evaluation allocates nothing after the first block.
class Scratch {
 public:
  class Frame {
   public:
    explicit Frame(Scratch& scratch) : scratch_(scratch), used_(scratch.used_) {}
    ~Frame() { scratch_.used_ = used_; }
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;

    /// `count` uninitialised elements, 32-byte aligned; T must be trivially destructible.
    template <class T>
    T* take(size_t count) {
      return static_cast<T*>(scratch_.take(count * sizeof(T)));
    }

   private:
    Scratch& scratch_;
    size_t used_;
  };

 private:
  struct Slab {
    std::unique_ptr<std::byte[]> memory;
    std::byte* start = nullptr;
    size_t bytes = 0;
  };
  void* take(size_t bytes);

  std::vector<Slab> slabs_;  // one array each; used_ of them are in use
  size_t used_ = 0;
};

}  // namespace vug::field
