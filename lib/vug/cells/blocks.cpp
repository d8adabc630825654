// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/blocks.h>

#include <algorithm>
#include <numeric>

namespace vug::cells {
namespace {

std::pair<uint32_t, uint32_t> near_links(const Links& links, uint32_t first, uint32_t end) {
  const uint32_t least = first - std::min(first, kBlock);
  const uint32_t most = std::min(static_cast<uint32_t>(links.size()), end + kBlock);
  uint32_t from = first, to = end;
  for (uint32_t k = links.begin[first]; k < links.begin[end]; ++k) {
    const uint32_t other = links.to[k];
    if (other < least || other >= most) return {0, 0};
    from = std::min(from, other);
    to = std::max(to, other + 1);
  }
  return {from, to};
}

}  // namespace

Blocks::Blocks(const Links& links, const std::vector<CellState>& states)
    : cells_(static_cast<uint32_t>(links.size())) {
  const size_t blocks = (links.size() + kBlock - 1) / kBlock;
  degree_.resize(blocks);
  around_.resize(blocks);
  receiving_.resize(blocks);
  silent_.resize(blocks);
  parallel_for(blocks, [&](size_t b) {
    const auto block = static_cast<uint32_t>(b);
    const uint32_t degree = links.degree(first(block));
    bool same = true;
    for (uint32_t i = first(block); i < end(block); ++i) same &= links.degree(i) == degree;
    degree_[b] = same ? degree : 0;
    around_[b] = near_links(links, first(block), end(block));
  });
  update(all(), states);
}

std::vector<uint32_t> Blocks::all() const {
  std::vector<uint32_t> every(receiving_.size());
  std::iota(every.begin(), every.end(), 0U);
  return every;
}

void Blocks::update(const std::vector<uint32_t>& blocks, const std::vector<CellState>& states) {
  parallel_for(blocks.size(), [&](size_t b) {
    const uint32_t block = blocks[b];
    uint32_t receiving = 0, silent = 0;
    for (uint32_t i = first(block); i < end(block); ++i) {
      receiving += receives(states[i]);
      silent += !distributes(states[i]);
    }
    receiving_[block] = receiving;
    silent_[block] = silent;
  });
  active_.clear();
  for (uint32_t block = 0; block < count(); ++block)
    if (receiving_[block] > 0) active_.push_back(block);
  silent_total_ = std::accumulate(silent_.begin(), silent_.end(), uint64_t{0});
}

}  // namespace vug::cells
