// SPDX-License-Identifier: Apache-2.0
#include <vug/field/scratch.h>

#include <cstdint>

namespace vug::field {

void* Scratch::take(size_t bytes) {
  constexpr size_t kAlignment = 32;
  if (used_ == slabs_.size()) slabs_.emplace_back();
  Slab& slab = slabs_[used_++];
  if (slab.bytes < bytes) {
    slab.memory.reset(new std::byte[bytes + kAlignment]);
    const auto address = reinterpret_cast<uintptr_t>(slab.memory.get());
    slab.start = slab.memory.get() + (kAlignment - address % kAlignment) % kAlignment;
    slab.bytes = bytes;
  }
  return slab.start;
}

}  // namespace vug::field
