// SPDX-License-Identifier: Apache-2.0
// The materials of unions, intersections and differences.
#include <vug/field/fold_node.h>
#include <vug/field/material_mean.h>

#include <cmath>
#include <optional>

namespace vug::field {

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

namespace {

/// A fold of values in single precision, and bounds of its errors.
struct NearFold {
  explicit NearFold(size_t count) : values(count, kInfinity), errors(count, 0) {}
  double most() const {
    double out = -kInfinity;
    for (size_t i = 0; i < values.size(); ++i) out = std::max(out, values[i] + errors[i]);
    return out;
  }
  std::vector<double> values, errors;
};

}  // namespace

/// The same fold in single precision. A mix is unknown where operands blend, or may blend.
NearMixes FoldNode::mixes_near(const NearPoints& points) const {
  const auto mixes = [&](const Operand& o) { return o.sign == sign_ || is_complement(); };
  size_t count = operands_.size();  // Later ones add no materials.
  while (count > 0 && !mixes(operands_[count - 1])) --count;
  const double reach = blend_.profile == Profile::sharp ? 0 : blend_.radius;
  NearMixes out(points.size(), {}, true);
  NearFold folded(points.size());
  std::vector<uint8_t> coated(points.size(), 0);
  for (size_t i = 0; i < operands_.size(); ++i) {
    const Operand& operand = operands_[i];
    if (operand.sign != sign_)
      for (size_t k = 0; k < points.size(); ++k)
        if (coat_at(*operand.node, points.at[k]).share > 0) coated[k] = 1;
    if (i >= count) continue;
    const double most = folded.most() + reach;
    bool complete = true;
    for (size_t k = 0; k < points.size(); ++k) complete = complete && !out.is_open(k);
    if (complete && operand.reach.least(points.ball) > most) continue;
    // Values do not matter if the first operand is also the last with materials.
    const bool only = i == 0 && count == 1;
    NearValues own;
    if (!only) own = values_near(*operand.node, points, operand.sign > 0 ? most : kInfinity);
    if (complete && !only && own.values.empty()) continue;
    const std::optional<NearMixes> added =
        mixes(operand) ? std::optional(field::mixes_near(*operand.node, points)) : std::nullopt;
    for (size_t k = 0; k < points.size(); ++k) {
      if (only) {
        out.replace(k, *added);
        continue;
      }
      const double value = own.values.empty() ? kInfinity : operand.sign * double{own.values[k]};
      const double gap = value - folded.values[k], error = own.error + folded.errors[k];
      const bool first = folded.values[k] == kInfinity;
      const bool lower = first || gap < -(reach + error);
      const bool higher = !first && gap > reach + error;
      if (added) {
        if (lower || out.is_open(k))
          out.replace(k, *added);
        else if (!higher)
          out.known[k] = 0;
      }
      if (!lower && !higher) folded.errors[k] += blend_.depth();
      folded.errors[k] = std::max(folded.errors[k], std::isnan(value) ? kInfinity : own.error);
      folded.values[k] = std::min(folded.values[k], value);
    }
  }
  for (size_t k = 0; k < points.size(); ++k)
    if (coated[k]) out.known[k] = 0;
  return out;
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

}  // namespace vug::field
