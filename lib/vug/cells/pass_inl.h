// SPDX-License-Identifier: Apache-2.0
// Templates of pass.h.
#pragma once

#include <vug/cells/simulation.h>

#include <algorithm>
#include <array>

namespace vug::cells {

template <class T>
AttributeReader<T> Pass::reads(const std::string& name, const T& initial) {
  return {simulation_->attributes().column<T>(name, initial).now.data()};
}

template <class T>
AttributeWriter<T> Pass::writes(const std::string& name, const T& initial) {
  return write(simulation_->attributes().column<T>(name, initial));
}

template <class T>
AttributeWriter<T> Pass::write(Column<T>& column) {
  if (column.next.empty()) column.next = column.now;
  const decltype(written_)::value_type written = &column;
  if (std::find(written_.begin(), written_.end(), written) == written_.end())
    written_.push_back(written);
  return {column.now.data(), column.next.data()};
}

template <class Kernel>
void Pass::run_distributing(uint32_t block, uint32_t from, uint32_t end,
                            const Kernel& kernel) const {
  const Links& links = network_->links;
  const uint32_t first = blocks_->first(block);
  const auto over = [&](const auto& neighbours) {
    // A local copy, so that the compiler knows that it does not change.
    const Kernel own = kernel;  // NOLINT(performance-unnecessary-copy-initialization)
    for (uint32_t i = from; i < end; ++i) own(neighbours, i);
  };
  const uint32_t* to = links.to.data() + links.begin[first];
  switch (blocks_->degree(block)) {
    case 3:
      return over(RegularNeighbourhood<3>{to, first});
    case 4:
      return over(RegularNeighbourhood<4>{to, first});
    case 6:
      return over(RegularNeighbourhood<6>{to, first});
    case 8:
      return over(RegularNeighbourhood<8>{to, first});
    default:
      return over(UniformNeighbourhood{links.begin.data(), links.to.data()});
  }
}

template <class Kernel>
void Pass::run_block(uint32_t block, const Kernel& kernel) const {
  const uint32_t first = blocks_->first(block), end = blocks_->end(block);
  const bool all = !where_ && blocks_->all_receive(block);
  if (all && blocks_->all_distribute()) return run_distributing(block, first, end, kernel);
  const Links& links = network_->links;
  const MixedNeighbourhood neighbours{links.begin.data(), links.to.data(), states_->data()};
  if (all) {
    const Kernel own = kernel;  // NOLINT(performance-unnecessary-copy-initialization)
    for (uint32_t i = first; i < end; ++i) own(neighbours, i);
    return;
  }
  std::array<uint32_t, kBlock> picked;  // NOLINT: filled by pick
  const uint32_t count = pick(block, picked.data());
  for (uint32_t k = 0; k < count; ++k) kernel(neighbours, picked[k]);
}

template <class Kernel>
void Pass::run(const Kernel& kernel) {
  const std::vector<uint32_t> blocks = blocks_->active();
  parallel_for(blocks.size(), [&](size_t b) { run_block(blocks[b], kernel); });
  finish(blocks, false);
}

template <class Kernel>
void Pass::run_everywhere(const Kernel& kernel) {
  const std::vector<uint32_t> blocks = blocks_->all();
  const MixedNeighbourhood neighbours{network_->links.begin.data(), network_->links.to.data(),
                                      states_->data()};
  parallel_for(blocks.size(), [&](size_t b) {
    for (uint32_t i = blocks_->first(blocks[b]); i < blocks_->end(blocks[b]); ++i)
      !where_ || (*where_)[i] ? kernel(neighbours, i) : keep(i);
  });
  finish(blocks, true);
}

}  // namespace vug::cells
