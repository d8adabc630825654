// SPDX-License-Identifier: Apache-2.0
// Pass::run_on_sums, which sums the values of neighbours in blocks that fit into the cache.
// Neighbours are scattered in memory, and two attributes of a cell are in two places. Therefore a
// block copies its surroundings as pairs that fit into the second-level cache, and sums those.
#pragma once

#include <vug/cells/pass_inl.h>

#include <cstring>

namespace vug::cells {

/// Two attributes of a block and of all cells linked to it, interleaved.
class Pairs {
 public:
  using Quad = float __attribute__((vector_size(16)));

  Pairs(uint32_t first, uint32_t end, const float* a, const float* b)  // NOLINT: set below
      : first_(first) {
    float* pair = pairs_.data();
    for (uint32_t n = first; n < end; ++n, pair += 2) {
      pair[0] = a[n];
      pair[1] = b[n];
    }
    pair[0] = pair[1] = 0;
  }

  /// Adds a cell's pair to the first two lanes of a sum. It also loads the next pair, whose sum is
  /// unused, so that load and addition are one instruction.
  struct Adder {
    const float* pairs;
    void operator()(uint32_t cell, Quad& sum) const {
      Quad two;
      std::memcpy(&two, pairs + 2 * size_t{cell}, sizeof(two));
      sum += two;
    }
  };
  Adder adder() const { return {pairs_.data() - 2 * size_t{first_}}; }

 private:
  uint32_t first_;
  alignas(64) std::array<float, 2 * (3 * size_t{kBlock} + 1)> pairs_;
};

template <class React>
void Pass::run_on_sums(const AttributeWriter<float>& a, const AttributeWriter<float>& b,
                       const React& react) {
  const auto set = [=](uint32_t i, FloatPair sum, float count) {
    const FloatPair next = react(FloatPair{a[i], b[i]}, sum, count);
    a.set(i, next.a);
    b.set(i, next.b);
  };
  const auto one_by_one = [=](const auto& neighbours, uint32_t i) {
    FloatPair sum{0, 0};
    const uint32_t count = neighbours.each(i, [&](uint32_t n) { sum.a += a[n], sum.b += b[n]; });
    set(i, sum, static_cast<float>(count));
  };
  const std::vector<uint32_t> blocks = blocks_->active();
  parallel_for(blocks.size(), [&](size_t at) {
    const uint32_t block = blocks[at];
    const auto [first_near, end_near] = blocks_->around(block);
    if (where_ || !blocks_->all_distribute() || !blocks_->all_receive(block) ||
        first_near == end_near)
      return run_block(block, one_by_one);
    const Pairs pairs(first_near, end_near, a.now, b.now);
    constexpr uint32_t kTurn = 512;
    std::array<FloatPair, kTurn> sums;  // NOLINT: set before they are read
    std::array<float, kTurn> counts;    // NOLINT: set before they are read
    for (uint32_t from = blocks_->first(block); from < blocks_->end(block); from += kTurn) {
      const uint32_t end = std::min(from + kTurn, blocks_->end(block));
      const auto gather = [=, add = pairs.adder(), to_sum = sums.data(), to_count = counts.data()](
                              const auto& neighbours, uint32_t i) {
        Pairs::Quad sum = {0, 0, 0, 0};
        const uint32_t count = neighbours.each(i, [&](uint32_t n) { add(n, sum); });
        to_sum[i - from] = {sum[0], sum[1]};
        to_count[i - from] = static_cast<float>(count);
      };
      run_distributing(block, from, end, gather);
      for (uint32_t i = from; i < end; ++i) set(i, sums[i - from], counts[i - from]);
    }
  });
  finish(blocks, false);
}

}  // namespace vug::cells
