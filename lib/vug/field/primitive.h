// SPDX-License-Identifier: Apache-2.0
// Node and kind of a primitive's formula.
#pragma once

#include <vug/field/kind.h>

#include <type_traits>

namespace vug::field {

/// P has: template <class T> T distance(const Point<T>&) const   (metres, negative inside)
///        Box3d bounds() const                                   (around the inside)
///        double lipschitz() const, Exactness exactness() const  (optional: 1 and exact)
///        double growth() const   (optional: 1/2 if not exact; see Traits::growth_rate)
///        P translated(const Vec3d& by) const   (optional: P moved by a vector)
/// A parameter struct whose formula needs derived constants has `shape()` instead, which returns a
/// struct P as above; it is called once.
template <class P>
class PrimitiveNode final : public EvaluationModes<PrimitiveNode<P>> {
 public:
  PrimitiveNode(std::string name, P params)
      : PrimitiveNode(std::move(name), params, digest_of(params)) {}
  /// `parameters`: the digest of the numbers of which P consists or from which it is computed.
  PrimitiveNode(std::string name, P params, Digest parameters)
      : EvaluationModes<PrimitiveNode<P>>(traits_of(params)),
        name_(std::move(name)),
        params_(std::move(params)),
        parameters_(parameters) {}

  template <class T>
  T at(const Point<T>& p) const {
    return params_.distance(p);
  }
  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch&) const {
    if constexpr (std::is_trivially_copyable_v<P>) {
      const P local = params_;  // cannot alias `out`, so constants stay in registers
      for (int i = 0; i < count; ++i) out[i] = local.distance(point_for<T>(points[i]));
    } else {
      for (int i = 0; i < count; ++i) out[i] = params_.distance(point_for<T>(points[i]));
    }
  }
  NodePtr translated(const Vec3d& by) const override {
    if constexpr (requires { params_.translated(by); })
      return std::make_shared<PrimitiveNode>(name_, params_.translated(by),
                                             Digester()(parameters_, by).finish());
    else
      return nullptr;
  }
  std::string name() const override { return name_; }

 protected:
  void add_to(Digester& digester) const override { digester(name_, parameters_); }

 private:
  static Traits traits_of(const P& params) {
    Traits traits;
    traits.bounds = params.bounds();
    if constexpr (requires { params.lipschitz(); }) traits.lipschitz = params.lipschitz();
    if constexpr (requires { params.exactness(); }) traits.exactness = params.exactness();
    traits.growth = 0.5;
    if constexpr (requires { params.growth(); }) traits.growth = params.growth();
    return traits;
  }
  std::string name_;
  P params_;
  Digest parameters_;
};

template <class P>
Field primitive_field(const std::string& name, const P& params) {
  return Field(std::make_shared<PrimitiveNode<P>>(name, params));
}

/// The primitive of a shape that is computed from parameters.
template <class P>
auto shaped_field(const std::string& name, const P& params) {
  using Shape = decltype(params.shape());
  return Field(std::make_shared<PrimitiveNode<Shape>>(name, params.shape(), digest_of(params)));
}

template <class P>
FieldKind primitive_kind(const std::string& name) {
  return field_kind<P>(name, "primitive", [name](const P& params) {
    if constexpr (requires { params.shape(); })
      return shaped_field(name, params);
    else
      return primitive_field(name, params);
  });
}

}  // namespace vug::field
