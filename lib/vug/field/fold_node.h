// SPDX-License-Identifier: Apache-2.0
// Internal to field/: one node serves union, intersection and difference, sign * smin(sign_i *
// child_i), by De Morgan. Children fold from left to right, so an n-ary blend has a defined order.
#pragma once

#include <vug/field/blend.h>
#include <vug/field/box_lanes.h>
#include <vug/field/material_source.h>
#include <vug/field/near_materials.h>
#include <vug/field/numbers/value_of.h>
#include <vug/field/operand_list.h>
#include <vug/field/operands.h>

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace vug::field {

/// Computes the Lipschitz constant and exactness of a fold.
void set_slope(Traits& traits, const OperandList& operands, const Blend& blend);

class FoldNode final : public EvaluationModes<FoldNode>,
                       public MaterialSource,
                       public NearMaterials,
                       public EvaluatesBelow {
 public:
  /// `order`: see order_.
  FoldNode(Traits traits, OperandList operands, double sign, Blend blend,
           std::vector<uint32_t> order = {})
      : EvaluationModes(std::move(traits)),
        operands_(std::move(operands)),
        sign_(sign),
        blend_(blend),
        order_(std::move(order)) {
    const auto skips = [](const Operand& operand) { return operand.below != nullptr; };
    if (operands_.size() > kFew || std::any_of(operands_.begin(), operands_.end(), skips)) {
      boxes_.reserve(operands_.size());
      for (const Operand& operand : operands_)
        boxes_.add(operand.reach.box, operand.reach.growth, operand.reach.depth);
    }
  }

  template <class T>
  T at(const Point<T>& p) const {
    if constexpr (!std::is_same_v<T, Interval>)
      if (operands_.size() >= kMany && is_plain_union()) return at_near(p);
    T folded = operands_[0].node->eval(p) * T(operands_[0].sign);
    for (size_t i = 1; i < operands_.size(); ++i)
      folded = blend_.smin(folded, operands_[i].node->eval(p) * T(operands_[i].sign));
    return folded * T(sign_);
  }

  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch& scratch) const {
    eval(order_.empty() ? 0 : order_[0], points, count, out, scratch);
    if (!boxes_.empty()) {
      add_near_operands(1, points, count, out, scratch);
    } else if (operands_.size() > 1) {
      Scratch::Frame frame(scratch);
      T* next = frame.template take<T>(static_cast<size_t>(count));
      for (size_t i = 1; i < operands_.size(); ++i) {
        eval(i, points, count, next, scratch);
        if (blend_.profile == Profile::sharp)
          for (int k = 0; k < count; ++k) out[k] = min(out[k], next[k]);
        else
          for (int k = 0; k < count; ++k) out[k] = blend_.smin(out[k], next[k]);
      }
    }
    flip(out, count, sign_);
  }
  void eval_below(const Point<Pack>* points, const Pack* limits, int count, Pack* out,
                  Scratch& scratch) const override {
    fill_below(points, limits, count, out, scratch);
  }
  void eval_below(const Point<Pack>* points, const Pack* limits, int count, Dual<Pack>* out,
                  Scratch& scratch) const override {
    fill_below(points, limits, count, out, scratch);
  }

  Restriction restrict_to(const Ball& ball) const override { return restricted(ball, kInfinity); }
  Restriction restrict_below(const Ball& ball, double limit) const override {
    return restricted(ball, is_plain_union() ? limit : kInfinity);
  }

  NodePtr translated(const Vec3d& by) const override;
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
  NearMixes mixes_near(const NearPoints& points) const override;
  Coat coat(const Vec3d& p) const override;
  std::optional<Field> material_mean(const MaterialNumber& number) const override;
  std::vector<NodePtr> material_operands() const override { return children(); }
  /// Prepares unions of many operands for sample_materials, which skips groups of far ones.
  void group_operands();

 protected:
  void add_to(Digester& digester) const override { digester(operands_, sign_, blend_); }

 private:
  static constexpr size_t kGroup = 16;
  static constexpr size_t kFew = 4;              // A test of these would not pay.
  static constexpr std::ptrdiff_t kSorted = 16;  // The others are rarely evaluated.
  static constexpr size_t kOrdered = 512;  // More are restricted again before they are evaluated.
  static constexpr size_t kMany = 32;      // At single points, a search among these does not pay.
  bool is_plain_union() const { return sign_ > 0 && blend_.profile == Profile::sharp; }
  bool is_complement() const { return operands_.size() == 1 && operands_[0].sign != sign_; }
  template <class T>
  static void flip(T* values, int count, double sign) {
    if (sign > 0) return;
    for (int k = 0; k < count; ++k) values[k] = -values[k];
  }

  Restriction restricted(const Ball& ball, double limit) const;
  /// The minimum over the operands that can have it, in order, of a plain union.
  template <class T>
  T at_near(const Point<T>& p) const {
    const Vec3d here(value_of(p.x), value_of(p.y), value_of(p.z));
    const size_t first = boxes_.nearest(here).value_or(0);
    double least = operands_[first].node->eval(point(here)) * operands_[first].sign;
    std::vector<uint32_t> near;
    boxes_.find_candidates({here, 0}, least, near);
    T folded(kInfinity);
    for (const uint32_t i : near) {
      const Operand& operand = operands_[i];
      if (operand.reach.least({here, 0}) > least) continue;
      folded = min(folded, operand.node->eval(p) * T(operand.sign));
      least = std::min(least, value_of(folded));
    }
    return folded;
  }
  template <class T>
  void eval(size_t i, const Point<Pack>* points, int count, T* out, Scratch& scratch) const {
    operands_[i].node->eval(points, count, out, scratch);
    flip(out, count, operands_[i].sign);
  }
  /// A union of many operands begins with the limits in place of the first operand.
  template <class T>
  void fill_below(const Point<Pack>* points, const Pack* limits, int count, T* out,
                  Scratch& scratch) const {
    if (boxes_.empty() || !is_plain_union()) return fill(points, count, out, scratch);
    for (int k = 0; k < count; ++k) out[k] = without_derivatives<T>(limits[k]);
    add_near_operands(0, points, count, out, scratch);
  }
  /// Adds the operands from `first` on, in order, each only where it can matter. The result is the
  /// same as without an order: of equal values, the one of the last operand counts.
  template <class T>
  void add_near_operands(size_t first, const Point<Pack>* points, int count, T* out,
                         Scratch& scratch) const;

  OperandList operands_;
  double sign_;
  Blend blend_;
  BoxLanes boxes_;               // Empty if a test would not pay.
  std::vector<uint32_t> order_;  // Of evaluation, the nearest first; empty: as they are.
  std::vector<Reach> groups_;    // Of kGroup consecutive operands; empty: not grouped.
};

}  // namespace vug::field
