// SPDX-License-Identifier: Apache-2.0
#include <vug/passages/sweep/capsule_list.h>

#include <array>
#include <bit>
#include <utility>

namespace vug::passages {
namespace {

constexpr double kNoInside = -1e30;

/// For each set of lanes, their indices in ascending order.
constexpr auto kLanesOf = [] {
  std::array<std::array<uint8_t, 8>, 256> table{};
  for (size_t bits = 0; bits < 256; ++bits)
    for (size_t lane = 0, count = 0; lane < 8; ++lane)
      if (bits >> lane & 1) table[bits][count++] = static_cast<uint8_t>(lane);
  return table;
}();

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
  const auto* indices = reinterpret_cast<const __m128i*>(kLanesOf[lanes].data());
  const __m256i order = _mm256_cvtepu8_epi32(_mm_loadl_epi64(indices));
  float* to = numbers_.data() + size_;
  for (size_t i = 0; i < kNumbers; ++i)
    Pack(_mm256_permutevar8x32_ps(other.load(i, pack).v, order)).store(to + i * stride_);
  size_ += more;
  end();
}

}  // namespace vug::passages
