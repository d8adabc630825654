// SPDX-License-Identifier: Apache-2.0
#include <vug/passages/sweep/capsule_list.h>
#include <vug/passages/sweep/lane_order.h>

#include <bit>
#include <utility>

namespace vug::passages {
namespace {

constexpr double kNoInside = -1e30;

}  // namespace

void CapsuleList::reserve(size_t size) {
  const size_t stride = (size + 2 * Pack::kLanes - 1) / Pack::kLanes * Pack::kLanes;
  if (stride <= stride_) return;
  std::vector<float> numbers(kNumbers * stride);
  for (size_t i = 0; i < kNumbers; ++i)
    for (size_t k = 0; k < size_; ++k) numbers[i * stride + k] = numbers_[i * stride_ + k];
  numbers_ = std::move(numbers);
  stride_ = stride;
}

void CapsuleList::make_room(size_t more) {
  if (size_ + more + Pack::kLanes > stride_) reserve(2 * (size_ + more));
}

/// Lanes beyond the size have no inside; their other numbers are finite.
void CapsuleList::end() {
  Pack(kNoInside).store(numbers_.data() + kReach * stride_ + size_);
  Pack(1.0).store(numbers_.data() + kScale * stride_ + size_);
  Pack(0.0).store(numbers_.data() + kFillet * stride_ + size_);
}

void CapsuleList::append(const Capsule& capsule, double fillet) {
  make_room(1);
  const double reach = capsule.reach + CapsulePack::kRounding * 2 * capsule.length;
  const double numbers[kNumbers] = {
      capsule.start.x, capsule.start.y, capsule.start.z, capsule.along.x, capsule.along.y,
      capsule.along.z, capsule.length,  reach,           capsule.scale,   fillet};
  for (size_t i = 0; i < kNumbers; ++i)
    numbers_[i * stride_ + size_] = static_cast<float>(numbers[i]);
  ++size_;
  end();
}

void CapsuleList::append(const CapsuleList& other, size_t pack, unsigned lanes) {
  const auto more = static_cast<size_t>(std::popcount(lanes));
  make_room(more);
  const __m256i order = lane_order(kLanesOf, lanes);
  float* to = numbers_.data() + size_;
  for (size_t i = 0; i < kNumbers; ++i)
    permuted(other.load(i, pack), order).store(to + i * stride_);
  size_ += more;
  end();
}

}  // namespace vug::passages
