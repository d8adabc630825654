// SPDX-License-Identifier: Apache-2.0
// Named curves of a scene, which guide turtles.
#pragma once

#include <vug/base/bezier.h>
#include <vug/base/kind.h>

namespace vug::shot {

/// The kinds listed in CMakeLists.txt.
const Kinds<Bezier>& curve_kinds();

using CurveKind = Kind<Bezier>;

/// Begins the definition of the function that the source of a curve kind exports.
#define VUG_CURVE_KIND(name) VUG_EXPORT_KIND(vug::shot, CurveKind, name##_curve)

}  // namespace vug::shot

namespace vug {

template <>
struct ValueTraits<Bezier> : ObjectTraits<Bezier> {
  static constexpr const char* kWord = "curve";
};

}  // namespace vug
