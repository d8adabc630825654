// One node serves union, intersection and difference: sign * smin(sign_i * child_i), by
// De Morgan. Children fold from left to right, so an n-ary blend has a defined order.
#include <vug/field/boolean.h>
#include <vug/field/constant.h>

#include <algorithm>
#include <utility>

namespace vug::field {
namespace {

struct Operand {
  NodePtr node;
  double sign = 1;  // the fold sees sign * node
};

class FoldNode final : public Readings<FoldNode> {
 public:
  FoldNode(Traits traits, std::vector<Operand> operands, double sign, Blend blend)
      : Readings(std::move(traits)), operands_(std::move(operands)), sign_(sign), blend_(blend) {}

  template <class T>
  T at(const Point<T>& p) const {
    T folded = operands_[0].node->eval(p) * T(operands_[0].sign);
    for (size_t i = 1; i < operands_.size(); ++i)
      folded = blend_.smin(folded, operands_[i].node->eval(p) * T(operands_[i].sign));
    return folded * T(sign_);
  }

  template <class T>
  void fill(const Point<T>* points, int count, T* out, Scratch& scratch) const {
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
  std::vector<NodePtr> children() const override {
    std::vector<NodePtr> out;
    for (const Operand& operand : operands_) out.push_back(operand.node);
    return out;
  }

 private:
  template <class T>
  static void flip(T* values, int count, double sign) {
    if (sign > 0) return;
    for (int k = 0; k < count; ++k) values[k] = -values[k];
  }

  std::vector<Operand> operands_;
  double sign_;
  Blend blend_;
};

/// Lipschitz constant and exactness of a fold.
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

/// A union of hundreds is restricted once per block, so this neither allocates for dropped
/// operands nor recomputes bounds: the node's own still hold for fewer operands.
Restriction FoldNode::restrict_to(const Ball& ball) const {
  struct Kept {
    Interval range;
    const Operand* operand;
    NodePtr smaller;
  };
  thread_local std::vector<std::vector<Kept>> pool;  // one list per depth of recursion
  thread_local size_t depth = 0;
  struct Depth {
    Depth() { ++depth; }
    ~Depth() { --depth; }
  } guard;
  if (pool.size() < depth) pool.resize(depth);
  std::vector<Kept> kept = std::move(pool[depth - 1]);
  kept.clear();

  // Each drop below leaves the fold's value as it is: smin(a, b) = a where b >= a + reach.
  const bool sharp = blend_.profile == Profile::sharp;
  const double reach = sharp ? 0 : blend_.radius;
  Interval folded(kInfinity, kInfinity);
  for (const Operand& operand : operands_) {
    Restriction r = operand.node->restrict_to(ball);
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
  if (sharp)  // a plain minimum does not depend on the order: drop what came before a lower one
    kept.erase(std::remove_if(kept.begin(), kept.end(),
                              [&](const Kept& k) { return k.range.lo > folded.hi; }),
               kept.end());

  Restriction out;
  out.range = signed_range(folded, sign_);
  const bool changed =
      kept.size() < operands_.size() ||
      std::any_of(kept.begin(), kept.end(), [](const Kept& k) { return k.smaller != nullptr; });
  if (kept.size() == 1 && kept[0].operand->sign == sign_) {
    out.node = kept[0].smaller ? kept[0].smaller : kept[0].operand->node;
  } else if (changed) {
    std::vector<Operand> operands;
    operands.reserve(kept.size());
    for (Kept& k : kept)
      operands.push_back({k.smaller ? k.smaller : k.operand->node, k.operand->sign});
    Traits traits = this->traits();
    set_slope(traits, operands, blend_);  // steep operands elsewhere do not matter here
    out.node = std::make_shared<FoldNode>(std::move(traits), std::move(operands), sign_, blend_);
  }
  kept.clear();
  pool[depth - 1] = std::move(kept);
  return out;
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
      if (is_finite(inside) || sign > 0) traits.growth = std::min(traits.growth, t.grows());
      if (is_finite(inside)) ++bounded;
    } else if (sign > 0) {
      traits.bounds = infinite_box();
    }
  }
  // The distance to a common part of boxes is at most sqrt(3) times the largest to one of them.
  if (sign < 0 && bounded > 1) traits.growth *= traits.bounds.isEmpty() ? 0 : 0.57735;
  return traits;
}

Field fold(std::vector<Operand> operands, double sign, const Blend& blend) {
  Traits traits = fold_traits(operands, sign, blend);
  return Field(std::make_shared<FoldNode>(std::move(traits), std::move(operands), sign, blend));
}

std::vector<Operand> with_sign(const std::vector<Field>& fields, double sign) {
  std::vector<Operand> operands;
  for (const Field& f : fields) operands.push_back({f.node(), sign});
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
  std::vector<Operand> operands = {{base.node(), -1}};
  for (const Operand& cut : with_sign(cuts, 1)) operands.push_back(cut);
  return fold(std::move(operands), -1, blend);
}

Field symmetric_difference(const Field& a, const Field& b, const Blend& blend) {
  return subtract(unite({a, b}, blend), {intersect({a, b}, blend)}, blend);
}

Field complement(const Field& a) { return fold({{a.node(), 1}}, -1, {}); }

}  // namespace vug::field
