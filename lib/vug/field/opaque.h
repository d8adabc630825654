// SPDX-License-Identifier: Apache-2.0
// Nodes of fields that have samples but no formula: meshes, grids, images.
#pragma once

#include <vug/field/enclosing_ball.h>
#include <vug/field/kind.h>

namespace vug::field {

/// S has: Gradient sample(const Vec3d& p) const   (value in metres and gradient; thread-safe)
///        double value(const Vec3d& p) const      (optional: if the value alone costs less)
///        NodePtr restricted(const Ball&, const Traits&) const   (optional: see Restriction::node)
/// Batches are evaluated lane by lane in double precision; intervals use the Lipschitz constant.
template <class S>
class OpaqueNode : public EvaluationModes<OpaqueNode<S>> {
 public:
  OpaqueNode(std::string name, Traits traits, S source)
      : EvaluationModes<OpaqueNode<S>>(std::move(traits)),
        name_(std::move(name)),
        source_(std::move(source)) {}

  double at(const Point<double>& p) const { return value(vector(p)); }
  template <class R>
  Dual<R> at(const Point<Dual<R>>& p) const {
    const Gradient g = source_.sample({p.x.v, p.y.v, p.z.v});
    return differentiated(R(g.value), constant<R>(g.gradient), p);
  }
  Interval at(const Point<Interval>& p) const {
    const Ball ball = enclosing_ball(p);
    return this->centre_form(value(ball.centre), ball);
  }

  void fill(const Point<Pack>* points, int count, Pack* out, Scratch&) const {
    for (int i = 0; i < count; ++i) {
      float xyz[3][Pack::kLanes], values[Pack::kLanes];
      store(points[i], xyz);
      for (int lane = 0; lane < Pack::kLanes; ++lane)
        values[lane] = static_cast<float>(value(lane_of(xyz, lane)));
      out[i] = Pack::load(values);
    }
  }
  void fill(const Point<Pack>* points, int count, Dual<Pack>* out, Scratch&) const {
    for (int i = 0; i < count; ++i) {
      const Lanes lanes = sample(points[i]);
      out[i] = {Pack::load(lanes.value), Pack::load(lanes.slope[0]), Pack::load(lanes.slope[1]),
                Pack::load(lanes.slope[2])};
    }
  }
  Restriction restrict_to(const Ball& ball) const override {
    Restriction out = Node::restrict_to(ball);
    if constexpr (requires { source_.restricted(ball, this->traits()); })
      out.node = source_.restricted(ball, this->traits());
    return out;
  }
  std::string name() const override { return name_; }
  const S& source() const { return source_; }

 protected:
  void add_to(Digester& digester) const override { digester(name_, source_); }

 private:
  double value(const Vec3d& p) const {
    if constexpr (requires { source_.value(p); })
      return source_.value(p);
    else
      return source_.sample(p).value;
  }
  static void store(const Point<Pack>& p, float (&xyz)[3][Pack::kLanes]) {
    p.x.store(xyz[0]);
    p.y.store(xyz[1]);
    p.z.store(xyz[2]);
  }
  static Vec3d lane_of(const float (&xyz)[3][Pack::kLanes], int lane) {
    return Vec3d(Vec3f(xyz[0][lane], xyz[1][lane], xyz[2][lane]));
  }
  struct Lanes {
    float value[Pack::kLanes];
    float slope[3][Pack::kLanes];
  };
  Lanes sample(const Point<Pack>& p) const {
    float xyz[3][Pack::kLanes];
    store(p, xyz);
    Lanes out;
    for (int lane = 0; lane < Pack::kLanes; ++lane) {
      const Gradient g = source_.sample(lane_of(xyz, lane));
      out.value[lane] = static_cast<float>(g.value);
      for (int axis = 0; axis < 3; ++axis)
        out.slope[axis][lane] = static_cast<float>(g.gradient[axis]);
    }
    return out;
  }

  std::string name_;
  S source_;
};

}  // namespace vug::field
