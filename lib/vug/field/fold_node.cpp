// SPDX-License-Identifier: Apache-2.0
#include <vug/field/fold_node.h>

#include <bit>
#include <cmath>

namespace vug::field {

template <class T>
void FoldNode::add_near_operands(size_t first, const Point<Pack>* points, int count, T* out,
                                 Scratch& scratch) const {
  constexpr int kMost = BoxLanes::kMostPoints;
  for (; count > kMost; points += kMost, out += kMost, count -= kMost)
    add_near_operands(first, points, kMost, out, scratch);
  const bool sharp = blend_.profile == Profile::sharp;
  const double radius = sharp ? 0 : blend_.radius;
  const auto size = static_cast<size_t>(count);
  Scratch::Frame frame(scratch);
  T* next = frame.template take<T>(size);
  auto* some = frame.template take<Point<Pack>>(size);
  int* which = frame.template take<int>(size);
  Pack* limits = frame.template take<Pack>(size);
  Pack* last = frame.template take<Pack>(size);  // The operand that has the value.
  auto* masks = frame.template take<uint64_t>(operands_.size());
  const double started = first == 0 ? -1 : order_.empty() ? 0 : order_[0];
  for (int k = 0; k < count; ++k) {
    last[k] = Pack(started);
    limits[k] = limit_for(value_of(out[k]), radius);
  }
  boxes_.find_candidates(points, limits, count, masks);
  for (size_t n = first; n < operands_.size(); ++n) {
    const size_t i = order_.empty() ? n : order_[n];
    int near = 0;
    for (uint64_t mask = masks[i]; mask != 0; mask &= mask - 1) {
      const int k = std::countr_zero(mask);
      const Pack limit = limit_for(value_of(out[k]), radius);
      if (boxes_.above(i, points[k], limit)) continue;
      some[near] = points[k];
      limits[near] = limit;
      which[near++] = k;
    }
    if (near == 0) continue;
    if (operands_[i].below)
      operands_[i].below->eval_below(some, limits, near, next, scratch);
    else
      eval(i, some, near, next, scratch);
    const Pack self(static_cast<double>(i));
    for (int j = 0; j < near; ++j) {
      T& value = out[which[j]];
      if (!sharp) {
        value = blend_.smin(value, next[j]);
        continue;
      }
      Pack& holder = last[which[j]];
      const PackMask lower = value_of(next[j]) < value_of(value);
      const PackMask later = (self > holder) & !(value_of(value) < value_of(next[j]));
      value = select(lower | later, next[j], value);
      holder = select(lower | later, self, holder);
    }
  }
}

template void FoldNode::add_near_operands(size_t, const Point<Pack>*, int, Pack*, Scratch&) const;
template void FoldNode::add_near_operands(size_t, const Point<Pack>*, int, Dual<Pack>*,
                                          Scratch&) const;

/// Computes the Lipschitz constant and exactness of a fold.
void set_slope(Traits& traits, const OperandList& operands, const Blend& blend) {
  traits.lipschitz = 0;
  traits.exactness = Exactness::exact;
  for (const Operand& operand : operands) {
    const Traits& t = operand.node->traits();
    traits.lipschitz = std::max(traits.lipschitz, t.lipschitz);
    traits.exactness = std::max(traits.exactness, t.exactness);
  }
  if (operands.size() > 1)
    traits.exactness = std::max(
        traits.exactness, blend.profile == Profile::sharp ? Exactness::eikonal : Exactness::bound);
}

namespace {

Interval signed_range(Interval range, double sign) { return sign > 0 ? range : -range; }

}  // namespace

/// A union of hundreds of operands is restricted once per block, so this neither allocates for
/// dropped operands nor recomputes bounds: the node's own bounds still hold for fewer operands.
Restriction FoldNode::restricted(const Ball& ball, double limit) const {
  struct KeptOperand {
    Interval range;
    const Operand* operand;
    NodePtr smaller;
    double distance;  // Of the centre from its box.
  };
  struct Lists {
    std::vector<KeptOperand> kept;
    std::vector<uint32_t> candidates;
  };
  thread_local std::vector<Lists> pool;  // One element per recursion depth.
  thread_local size_t depth = 0;
  struct Depth {
    Depth() { ++depth; }
    ~Depth() { --depth; }
  } guard;
  if (pool.size() < depth) pool.resize(depth);
  auto [kept, candidates] = std::move(pool[depth - 1]);
  kept.clear();
  candidates.clear();

  // Each drop below preserves the fold's value: smin(a, b) = a where b >= a + reach.
  const bool sharp = blend_.profile == Profile::sharp;
  const double reach = sharp ? 0 : blend_.radius;
  // The nearest operand first: operands above its values over the whole ball cannot be the minimum.
  const Operand* nearest = nullptr;
  Restriction of_nearest;
  double ceiling = limit;
  if (sharp && operands_.size() > 8) {
    if (const auto found = boxes_.nearest(ball.centre)) {
      nearest = &operands_[*found];
      of_nearest = nearest->node->restrict_to(ball);
      ceiling = std::min(limit, of_nearest.range.hi);
    }
    boxes_.find_candidates(ball, ceiling, candidates);
  } else {
    for (uint32_t i = 0; i < operands_.size(); ++i) candidates.push_back(i);
  }

  Interval folded(kInfinity, kInfinity);
  for (const uint32_t i : candidates) {
    const Operand& operand = operands_[i];
    const double distance = operand.reach.growth > 0 ? operand.reach.distance(ball.centre) : 0;
    const double least = operand.reach.least(ball, distance);
    if (least > ceiling || least > folded.hi + reach) continue;
    // Over a ball larger than the operand nothing inside it can be dropped.
    const bool coarse = nearest && operand.reach.growth > 0 && ball.radius > operand.reach.radius;
    const double most = std::min(ceiling, folded.hi + reach);
    Restriction r = &operand == nearest ? of_nearest
                    : coarse            ? Restriction{{least, kInfinity}, nullptr}
                    : operand.below     ? operand.below->restrict_below(ball, most)
                                        : operand.node->restrict_to(ball);
    const Interval range = signed_range(r.range, operand.sign);
    if (range.lo > folded.hi + reach) continue;
    if (folded.lo > range.hi + reach) {
      kept.clear();
      folded = range;
    } else {
      folded = {std::min(folded.lo, range.lo) - blend_.depth(), std::min(folded.hi, range.hi)};
    }
    kept.push_back({range, &operand, std::move(r.node), distance});
  }
  if (sharp)  // A plain minimum does not depend on the order: drop earlier operands above a lower
              // one.
    kept.erase(std::remove_if(kept.begin(), kept.end(),
                              [&](const KeptOperand& k) { return k.range.lo > folded.hi; }),
               kept.end());

  Restriction out;
  if (kept.empty()) folded = {std::nextafter(limit, kInfinity), kInfinity};
  out.range = signed_range(folded, sign_);
  const bool changed = kept.size() < operands_.size() ||
                       std::any_of(kept.begin(), kept.end(),
                                   [](const KeptOperand& k) { return k.smaller != nullptr; });
  if (kept.empty()) {
    out.node = nullptr;  // No value is below the limit.
  } else if (kept.size() == 1 && kept[0].operand->sign == sign_) {
    out.node = kept[0].smaller ? kept[0].smaller : kept[0].operand->node;
  } else if (changed) {
    const auto smaller = std::count_if(kept.begin(), kept.end(),
                                       [](const KeptOperand& k) { return k.smaller != nullptr; });
    OperandList operands(operands_, kept.size(), static_cast<size_t>(smaller));
    for (KeptOperand& k : kept)
      if (k.smaller)
        operands.replace(std::move(k.smaller), *k.operand);
      else
        operands.share(*k.operand);
    std::vector<uint32_t> order;
    if (sharp && kept.size() > kFew && kept.size() <= kOrdered) {
      thread_local std::vector<std::pair<float, uint32_t>> by_distance;
      by_distance.clear();
      for (const KeptOperand& k : kept)
        by_distance.emplace_back(static_cast<float>(k.distance),
                                 static_cast<uint32_t>(by_distance.size()));
      const auto first = by_distance.begin();
      std::partial_sort(first, first + std::min<std::ptrdiff_t>(kSorted, std::ssize(by_distance)),
                        by_distance.end());
      for (const auto& [distance, i] : by_distance) order.push_back(i);
    }
    Traits traits = this->traits();
    set_slope(traits, operands, blend_);  // Steep operands elsewhere do not matter here.
    out.node = std::make_shared<FoldNode>(std::move(traits), std::move(operands), sign_, blend_,
                                          std::move(order));
  }
  kept.clear();
  pool[depth - 1] = {std::move(kept), std::move(candidates)};
  return out;
}

NodePtr FoldNode::translated(const Vec3d& by) const {
  std::vector<Operand> operands;
  operands.reserve(operands_.size());
  for (const Operand& operand : operands_) operands.push_back(operand.translated(by));
  return std::make_shared<FoldNode>(traits().translated(by), std::move(operands), sign_, blend_,
                                    order_);
}

}  // namespace vug::field
