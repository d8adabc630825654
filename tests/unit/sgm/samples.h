// SPDX-License-Identifier: Apache-2.0
// Solids in closed form and the paper's experiment, for several tests.
#pragma once

#include <vug/field/affine.h>
#include <vug/field/boolean.h>
#include <vug/field/primitive.h>
#include <vug/field/registry.h>
#include <vug/sgm/derive.h>

namespace vug::sgm {

using field::Field;

struct TestBox {
  Vec3d half;
  template <class T>
  T distance(const field::Point<T>& p) const {
    using field::max;
    using field::min;
    const field::Point<T> q = field::abs(p) - field::constant<T>(half);
    return field::length(field::max(q, 0.0)) + min(max(max(q.x, q.y), q.z), T(0.0));
  }
  Box3d bounds() const { return {-half, half}; }
};

/// About the y axis.
struct TestTorus {
  double radius, tube;
  template <class T>
  T distance(const field::Point<T>& p) const {
    const T ring = field::length(p.x, p.z) - T(radius);
    return field::length(ring, p.y) - T(tube);
  }
  Box3d bounds() const {
    const Vec3d r(radius + tube, tube, radius + tube);
    return {-r, r};
  }
};

/// Below the plane through `at` with the outward unit normal.
struct TestHalfSpace {
  Vec3d normal;
  Vec3d at{0, 0, 0};
  template <class T>
  T distance(const field::Point<T>& p) const {
    return field::dot(p - field::constant<T>(at), field::constant<T>(normal));
  }
  Box3d bounds() const {
    Box3d box = infinite_box();
    for (int i = 0; i < 3; ++i)
      if (normal[i] == 1) box.max[i] = at[i];
    return box;
  }
};

template <class P>
Field solid(P params) {
  return Field(std::make_shared<field::PrimitiveNode<P>>("test", std::move(params)));
}
inline Field ball(double radius) { return field::make("sphere", {{"radius", radius}}); }
inline Field box(const Vec3d& half) { return solid(TestBox{half}); }
inline Field torus(double radius, double tube) { return solid(TestTorus{radius, tube}); }
inline Field moved(const Field& f, const Vec3d& by) {
  return field::transformed(f, Transform::translation(by));
}

inline ProductionStep step(Operation operation, Field f, Label label = Label::plus_x) {
  ProductionStep out;
  out.operation = operation;
  out.pieces = {{"shape", std::move(f)}};
  out.label = label;
  return out;
}

/// Figure 9: P_C = 10, P_M = 2, L_B = +X, M_P = 52 %, P_S = 3, on spheres, boxes and tori.
inline Rules figure9() {
  Rules rules;
  const auto size = [](RandomKey key) { return RandomStream(key).uniform(0.5, 1.0); };
  rules.shapes = {
      {"sphere", 2, [size](RandomKey key) { return ball(size(key)); }},
      {"box", 1,
       [size](RandomKey key) {
         return box(Vec3d(size(key.at("x")), size(key.at("y")), size(key.at("z"))));
       }},
      {"torus", 1, [size](RandomKey key) { return torus(size(key), 0.35 * size(key)); }}};
  return rules;
}

}  // namespace vug::sgm
