// SPDX-License-Identifier: Apache-2.0
// One node serves union, intersection and difference: sign * smin(sign_i * child_i), by De Morgan.
// Children fold from left to right, so an n-ary blend has a defined order.
#include <vug/field/boolean.h>
#include <vug/field/constant.h>
#include <vug/field/material_source.h>
#include <vug/field/operands.h>

#include <algorithm>
#include <utility>

namespace vug::field {
namespace {

/// Bounds of an operand's values from its box, without evaluating it: outside the box they
/// grow, and inside they are no lower than the distance to its surface. A fold of thousands of
/// operands is restricted over large balls with this information alone.
struct Reach {
  Box3d box;
  double growth = 0;  // 0: no information from the box.
  double depth = 0;   // Values inside are above -depth.
  double radius = 0;  // Radius of a ball around the box.

  Reach() = default;
  Reach(const Traits& traits, double sign) : box(traits.bounds) {
    if (sign < 0 || !is_finite(box)) return;
    const Vec3d size = box.size();
    growth = traits.growth_rate();
    depth = 0.5 * traits.lipschitz * std::min({size.x, size.y, size.z});
    radius = 0.5 * size.length();
  }
  /// The minimum of the values within `radius` of c.
  double least(const Ball& ball) const {
    if (growth <= 0) return -kInfinity;
    const double away = distance(ball.centre) - ball.radius;
    return away > 0 ? growth * away * (1 - 1e-6) - 1e-6 * ball.centre.length() : -depth * 1.001;
  }
  double distance(const Vec3d& c) const {
    double squared = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double d = std::max({box.min[axis] - c[axis], c[axis] - box.max[axis], 0.0});
      squared += d * d;
    }
    return std::sqrt(squared);
  }
};

struct Operand {
  Operand(NodePtr n, double s) : node(std::move(n)), sign(s), reach(node->traits(), sign) {}
  Operand(NodePtr smaller, const Operand& whole)  // Bounds of the whole also hold for a part.
      : node(std::move(smaller)), sign(whole.sign), reach(whole.reach) {}
  NodePtr node;
  double sign;  // The fold uses sign * node.
  Reach reach;
};

class FoldNode final : public EvaluationModes<FoldNode>, public MaterialSource {
 public:
  FoldNode(Traits traits, std::vector<Operand> operands, double sign, Blend blend)
      : EvaluationModes(std::move(traits)),
        operands_(std::move(operands)),
        sign_(sign),
        blend_(blend) {}

  template <class T>
  T at(const Point<T>& p) const {
    T folded = operands_[0].node->eval(p) * T(operands_[0].sign);
    for (size_t i = 1; i < operands_.size(); ++i)
      folded = blend_.smin(folded, operands_[i].node->eval(p) * T(operands_[i].sign));
    return folded * T(sign_);
  }

  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch& scratch) const {
    Scratch::Frame frame(scratch);
    T* next = frame.template take<T>(static_cast<size_t>(count));
    operands_[0].node->eval(points, count, out, scratch);
    flip(out, count, operands_[0].sign);
    for (size_t i = 1; i < operands_.size(); ++i) {
      operands_[i].node->eval(points, count, next, scratch);
      flip(next, count, operands_[i].sign);
      if (blend_.profile == Profile::sharp)
        for (int k = 0; k < count; ++k) out[k] = min(out[k], next[k]);
      else
        for (int k = 0; k < count; ++k) out[k] = blend_.smin(out[k], next[k]);
    }
    flip(out, count, sign_);
  }

  Restriction restrict_to(const Ball& ball) const override;

  std::string name() const override {
    const bool plain = std::all_of(operands_.begin(), operands_.end(),
                                   [&](const Operand& o) { return o.sign == sign_; });
    return !plain ? "difference" : sign_ > 0 ? "union" : "intersection";
  }
  Operands operands() const {
    Operands out;
    for (const Operand& operand : operands_)
      (operand.sign == sign_ ? out.kept : out.removed).push_back(operand.node);
    return out;
  }
  std::vector<NodePtr> children() const override {
    std::vector<NodePtr> out;
    for (const Operand& operand : operands_) out.push_back(operand.node);
    return out;
  }

  MaterialSample sample_materials(const Vec3d& p) const override;
  Coat coat(const Vec3d& p) const override;
  std::optional<Field> material_mean(const MaterialNumber& number) const override;
  std::vector<NodePtr> material_operands() const override { return children(); }
  /// Prepares unions of many operands for sample_materials, which skips groups of far ones.
  void group_operands();

 private:
  static constexpr size_t kGroup = 16;
  bool is_complement() const { return operands_.size() == 1 && operands_[0].sign != sign_; }
  template <class T>
  static void flip(T* values, int count, double sign) {
    if (sign > 0) return;
    for (int k = 0; k < count; ++k) values[k] = -values[k];
  }

  std::vector<Operand> operands_;
  double sign_;
  Blend blend_;
  std::vector<Reach> groups_;  // Of kGroup consecutive operands; empty: not grouped.
};

/// Computes the Lipschitz constant and exactness of a fold.
void set_slope(Traits& traits, const std::vector<Operand>& operands, const Blend& blend) {
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

Interval signed_range(Interval range, double sign) { return sign > 0 ? range : -range; }

/// A union of hundreds of operands is restricted once per block, so this neither allocates for
/// dropped operands nor recomputes bounds: the node's own bounds still hold for fewer operands.
Restriction FoldNode::restrict_to(const Ball& ball) const {
  struct KeptOperand {
    Interval range;
    const Operand* operand;
    NodePtr smaller;
  };
  thread_local std::vector<std::vector<KeptOperand>> pool;  // One list per recursion depth.
  thread_local size_t depth = 0;
  struct Depth {
    Depth() { ++depth; }
    ~Depth() { --depth; }
  } guard;
  if (pool.size() < depth) pool.resize(depth);
  std::vector<KeptOperand> kept = std::move(pool[depth - 1]);
  kept.clear();

  // Each drop below preserves the fold's value: smin(a, b) = a where b >= a + reach.
  const bool sharp = blend_.profile == Profile::sharp;
  const double reach = sharp ? 0 : blend_.radius;
  // The nearest operand first: operands above its values over the whole ball cannot be the minimum.
  const Operand* nearest = nullptr;
  Restriction of_nearest;
  if (sharp && operands_.size() > 8) {
    double least_distance = kInfinity;
    for (const Operand& operand : operands_) {
      if (operand.reach.growth <= 0) continue;
      const double d = (operand.reach.box.center() - ball.centre).length2();
      if (d < least_distance) {
        least_distance = d;
        nearest = &operand;
      }
    }
    if (nearest) of_nearest = nearest->node->restrict_to(ball);
  }
  double ceiling = kInfinity;
  if (nearest) ceiling = of_nearest.range.hi;

  Interval folded(kInfinity, kInfinity);
  for (const Operand& operand : operands_) {
    const double least = operand.reach.least(ball);
    if (least > ceiling || least > folded.hi + reach) continue;
    // Over a ball larger than the operand nothing inside it can be dropped.
    const bool coarse = nearest && operand.reach.growth > 0 && ball.radius > operand.reach.radius;
    Restriction r = &operand == nearest ? of_nearest
                    : coarse            ? Restriction{{least, kInfinity}, nullptr}
                                        : operand.node->restrict_to(ball);
    const Interval range = signed_range(r.range, operand.sign);
    if (range.lo > folded.hi + reach) continue;
    if (folded.lo > range.hi + reach) {
      kept.clear();
      folded = range;
    } else {
      folded = {std::min(folded.lo, range.lo) - blend_.depth(), std::min(folded.hi, range.hi)};
    }
    kept.push_back({range, &operand, std::move(r.node)});
  }
  if (sharp)  // A plain minimum does not depend on the order: drop earlier operands above a lower
              // one.
    kept.erase(std::remove_if(kept.begin(), kept.end(),
                              [&](const KeptOperand& k) { return k.range.lo > folded.hi; }),
               kept.end());

  Restriction out;
  out.range = signed_range(folded, sign_);
  const bool changed = kept.size() < operands_.size() ||
                       std::any_of(kept.begin(), kept.end(),
                                   [](const KeptOperand& k) { return k.smaller != nullptr; });
  if (kept.size() == 1 && kept[0].operand->sign == sign_) {
    out.node = kept[0].smaller ? kept[0].smaller : kept[0].operand->node;
  } else if (changed) {
    std::vector<Operand> operands;
    operands.reserve(kept.size());
    for (KeptOperand& k : kept)
      if (k.smaller)
        operands.emplace_back(std::move(k.smaller), *k.operand);
      else
        operands.push_back(*k.operand);
    Traits traits = this->traits();
    set_slope(traits, operands, blend_);  // Steep operands elsewhere do not matter here.
    out.node = std::make_shared<FoldNode>(std::move(traits), std::move(operands), sign_, blend_);
  }
  kept.clear();
  pool[depth - 1] = std::move(kept);
  return out;
}

void FoldNode::group_operands() {
  if (sign_ < 0 || operands_.size() < 2 * kGroup) return;
  std::vector<Reach> groups((operands_.size() + kGroup - 1) / kGroup);
  for (size_t i = 0; i < operands_.size(); ++i) {
    const Reach& own = operands_[i].reach;
    if (operands_[i].sign < 0 || own.growth <= 0) return;
    Reach& group = groups[i / kGroup];
    group.growth = i % kGroup == 0 ? own.growth : std::min(group.growth, own.growth);
    group.depth = std::max(group.depth, own.depth);
    group.box = united(group.box, own.box);
  }
  groups_ = std::move(groups);
}

/// A cut exposes the material of the base, unless it has a coat. An operand without materials has
/// those of the operands before or after it.
MaterialSample FoldNode::sample_materials(const Vec3d& p) const {
  const double reach = blend_.profile == Profile::sharp ? 0 : blend_.radius;
  double folded = kInfinity;
  MaterialMix mix, skin;
  double bare = 1;  // Share of the rock below the coats.
  for (size_t i = 0; i < operands_.size(); ++i) {
    if (!groups_.empty() && i % kGroup == 0 && !mix.empty() &&
        groups_[i / kGroup].least({p, 0}) > folded + reach) {
      i += kGroup - 1;
      continue;
    }
    const Operand& operand = operands_[i];
    const bool mixes = operand.sign == sign_ || is_complement();
    if (operand.sign != sign_)
      if (const Coat own = coat_at(*operand.node, p); own.share > 0) {
        const double covered = 1 - bare + bare * own.share;
        skin = mixed(skin, own.mix, bare * own.share / covered);
        bare *= 1 - own.share;
      }
    const bool matters = operand.reach.least({p, 0}) <= folded + reach;
    if (!matters && !(mixes && mix.empty())) continue;
    MaterialSample own;
    if (mixes)
      own = field::sample_materials(*operand.node, p);
    else
      own.value = operand.node->eval(point(p));
    own.value *= operand.sign;
    if (mixes) mix = mixed(mix, own.mix, folded < kInfinity ? blend_.share(folded, own.value) : 1);
    folded = folded < kInfinity ? blend_.smin(folded, own.value) : own.value;
  }
  if (bare < 1) mix = mixed(skin, mix, bare);
  return {folded * sign_, mix};
}

/// The coats of the kept operands lie over each other.
Coat FoldNode::coat(const Vec3d& p) const {
  Coat out;
  for (const Operand& operand : operands_) {
    if (operand.sign != sign_) continue;
    const Coat own = coat_at(*operand.node, p);
    if (!(own.share > 0)) continue;
    const double covered = 1 - (1 - out.share) * (1 - own.share);
    out.mix = mixed(out.mix, own.mix, 1 - out.share / covered);
    out.share = covered;
  }
  return out;
}

/// Coats are thinner than the contacts of a mean, so it does not contain them.
std::optional<Field> FoldNode::material_mean(const MaterialNumber& number) const {
  std::vector<MeanOperand> known;
  for (const Operand& operand : operands_)
    if (operand.sign == sign_ || is_complement())
      if (std::optional<Field> mean = field::material_mean(Field(operand.node), number))
        known.push_back({Field(operand.node), std::move(*mean)});
  if (known.empty()) return std::nullopt;
  return contact_mean(known, sign_, number);
}

/// Bounds of the inside; a blended union bulges by at most its depth at every fold.
Traits fold_traits(const std::vector<Operand>& operands, double sign, const Blend& blend) {
  Traits traits;
  set_slope(traits, operands, blend);
  traits.bounds = sign > 0 ? Box3d() : infinite_box();
  const double bulge = sign > 0 ? blend.depth() * static_cast<double>(operands.size() - 1) : 0;
  int bounded = 0;
  traits.growth = 1;
  for (const Operand& operand : operands) {
    const Traits& t = operand.node->traits();
    if (operand.sign == sign) {
      const Box3d inside = t.bounds_below(bulge);
      traits.bounds =
          sign > 0 ? united(traits.bounds, inside) : intersection(traits.bounds, inside);
      if (is_finite(inside) || sign > 0) traits.growth = std::min(traits.growth, t.growth_rate());
      if (is_finite(inside)) ++bounded;
    } else if (sign > 0) {
      traits.bounds = infinite_box();
    }
  }
  // The distance to an intersection of boxes is at most sqrt(3) times the largest distance to one
  // of them.
  if (sign < 0 && bounded > 1) traits.growth *= traits.bounds.isEmpty() ? 0 : 0.57735;
  return traits;
}

Field fold(std::vector<Operand> operands, double sign, const Blend& blend) {
  Traits traits = fold_traits(operands, sign, blend);
  auto node = std::make_shared<FoldNode>(std::move(traits), std::move(operands), sign, blend);
  node->group_operands();
  return Field(std::move(node));
}

std::vector<Operand> with_sign(const std::vector<Field>& fields, double sign) {
  std::vector<Operand> operands;
  for (const Field& f : fields) operands.emplace_back(f.node(), sign);
  return operands;
}

}  // namespace

Field unite(std::vector<Field> operands, const Blend& blend) {
  if (operands.empty()) return empty();
  if (operands.size() == 1) return operands[0];
  return fold(with_sign(operands, 1), 1, blend);
}

Field intersect(std::vector<Field> operands, const Blend& blend) {
  if (operands.empty())
    throw Error(ErrorCode::bad_input, "an intersection needs at least one operand");
  if (operands.size() == 1) return operands[0];
  return fold(with_sign(operands, -1), -1, blend);
}

Field subtract(Field base, std::vector<Field> cuts, const Blend& blend) {
  if (cuts.empty()) return base;
  std::vector<Operand> operands;
  operands.emplace_back(base.node(), -1);
  for (const Operand& cut : with_sign(cuts, 1)) operands.push_back(cut);
  return fold(std::move(operands), -1, blend);
}

Field symmetric_difference(const Field& a, const Field& b, const Blend& blend) {
  return subtract(unite({a, b}, blend), {intersect({a, b}, blend)}, blend);
}

Operands operands_of(const Node& node) {
  const auto* fold = dynamic_cast<const FoldNode*>(&node);
  return fold ? fold->operands() : Operands();
}

Field complement(const Field& a) { return fold({Operand(a.node(), 1)}, -1, {}); }

}  // namespace vug::field
