#include <vug/cells/blocks.h>

#include <algorithm>
#include <numeric>

namespace vug::cells {

Blocks::Blocks(const Links& links, const std::vector<State>& states)
    : cells_(static_cast<uint32_t>(links.size())) {
  const size_t blocks = (links.size() + kBlock - 1) / kBlock;
  degree_.resize(blocks);
  receiving_.resize(blocks);
  silent_.resize(blocks);
  parallel_for(blocks, [&](size_t b) {
    const auto block = static_cast<uint32_t>(b);
    const uint32_t degree = links.degree(first(block));
    bool same = true;
    for (uint32_t i = first(block); i < end(block); ++i) same &= links.degree(i) == degree;
    degree_[b] = same ? degree : 0;
  });
  update(all(), states);
}

std::vector<uint32_t> Blocks::all() const {
  std::vector<uint32_t> every(receiving_.size());
  std::iota(every.begin(), every.end(), 0U);
  return every;
}

void Blocks::update(const std::vector<uint32_t>& blocks, const std::vector<State>& states) {
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
  awake_.clear();
  for (uint32_t block = 0; block < count(); ++block)
    if (receiving_[block] > 0) awake_.push_back(block);
  silent_total_ = std::accumulate(silent_.begin(), silent_.end(), uint64_t{0});
}

}  // namespace vug::cells
