// SPDX-License-Identifier: Apache-2.0
#include <vug/volume/around_centre.h>

#include <algorithm>

namespace vug::volume {

AroundCentre::AroundCentre(const std::vector<Offset>& centre, int reach)
    : centre_(centre), reach_(reach) {
  const auto width = static_cast<size_t>(2 * reach + 1);
  labels_.resize(width * width * width);
}

uint8_t& AroundCentre::label(const Offset& at) {
  const int width = 2 * reach_ + 1;
  return labels_[static_cast<size_t>(((at[0] + reach_) * width + at[1] + reach_) * width + at[2] +
                                     reach_)];
}

bool AroundCentre::holds(const Offset& at) const {
  return std::count(centre_.begin(), centre_.end(), at) == 0 &&
         std::all_of(at.begin(), at.end(), [&](int each) { return std::abs(each) <= reach_; });
}

std::array<Offset, 6> AroundCentre::neighbours(const Offset& at) {
  std::array<Offset, 6> all;
  all.fill(at);
  for (size_t side = 0; side < 6; ++side) all[side][side / 2] += side % 2 ? 1 : -1;
  return all;
}

void AroundCentre::start(const Offset& at) {
  sets_.push_back({{at}, 1, sets_.size()});
  label(at) = static_cast<uint8_t>(sets_.size());
  ++roots_;
}

size_t AroundCentre::root(size_t set) const {
  while (sets_[set].parent != set) set = sets_[set].parent;
  return set;
}

size_t AroundCentre::smallest() const {
  size_t best = sets_.size();
  for (size_t set = 0; set < sets_.size(); ++set)
    if (sets_[set].parent == set && (best == sets_.size() || sets_[set].size < sets_[best].size))
      best = set;
  return best;
}

void AroundCentre::reach(size_t set, const Offset& at) {
  uint8_t& known = label(at);
  size_t own = root(set);
  if (known == 0) {
    known = static_cast<uint8_t>(own + 1);
    sets_[own].pending.push_back(at);
    ++sets_[own].size;
    return;
  }
  size_t other = root(known - size_t{1});
  if (other == own) return;
  if (sets_[own].pending.size() < sets_[other].pending.size()) std::swap(own, other);
  std::vector<Offset>& pending = sets_[own].pending;
  pending.insert(pending.end(), sets_[other].pending.begin(), sets_[other].pending.end());
  sets_[own].size += sets_[other].size;
  sets_[other] = {{}, 0, own};
  --roots_;
}

}  // namespace vug::volume
