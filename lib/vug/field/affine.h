// Fields carried along by an affine map.
#pragma once

#include <vug/base/transform.h>
#include <vug/field/field.h>

namespace vug::field {

/// The solid's image under `map`. Rigid maps and uniform scalings keep distances exact;
/// others give a lower bound: the child's value times the map's smallest stretch.
Field transformed(const Field& field, const Transform& map);

}  // namespace vug::field
