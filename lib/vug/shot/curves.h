// Curves that scenes name: what turtles are guided by.
#pragma once

#include <vug/base/bezier.h>
#include <vug/base/kind.h>

namespace vug::shot {

/// Made from the list in CMakeLists.txt.
const Kinds<Bezier>& curve_kinds();

using CurveKind = Kind<Bezier>;

/// Opens the one function that the file of a kind of curve exports.
#define VUG_CURVE_KIND(name) VUG_EXPORT_KIND(vug::shot, CurveKind, name##_curve)

}  // namespace vug::shot

namespace vug {

template <>
struct ValueTraits<Bezier> : ObjectTraits<Bezier> {
  static constexpr const char* kWord = "curve";
};

}  // namespace vug
