// SPDX-License-Identifier: Apache-2.0
// The space in which a mask or paint evaluates a point of an instance.
#pragma once

#include <vug/base/schema.h>
#include <vug/paint/paint.h>

namespace vug::paint {

enum class Space { own, scene };

/// Base of the parameters of masks and paints that depend on the position or the normal.
struct InSpace {
  Space space = Space::own;

  AttributeUses uses() const {
    AttributeUses none;
    none.refers_to_scene = space == Space::scene;
    return none;
  }
};

template <class P>
void describe_space(Schema<P>& s) {
  s.choice("in", static_cast<Space P::*>(&P::space), {{"own", Space::own}, {"scene", Space::scene}},
           "space of the point: that of the material, or always that of the scene, in which the "
           "instances of an object differ");
}

/// A function of an EvalPoint that evaluates `f` in the space of the parameters.
template <class F>
auto in_space(const InSpace& params, F f) {
  return [space = params.space, f = std::move(f)](const EvalPoint& point) {
    return f(space == Space::scene && point.in_scene ? *point.in_scene : point);
  };
}

}  // namespace vug::paint
