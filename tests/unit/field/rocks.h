// SPDX-License-Identifier: Apache-2.0
// Solids with materials, for tests.
#pragma once

#include <vug/field/affine.h>
#include <vug/field/registry.h>
#include <vug/field/rock_material_kind.h>

#include <string>
#include <vector>

namespace vug::field {

inline Field shifted(const Field& field, const Vec3d& by) {
  return transformed(field, Transform::translation(by));
}
inline Field of(const Field& field, const std::string& name, double hardness = 0) {
  const Value material =
      Object{"rock material",
             RockMaterialPtr(std::make_shared<RockMaterial>(RockMaterial{name, hardness}))};
  return make("made_of", {{"field", as_value(field)}, {"of", material}});
}
inline Field orb(double radius = 1) { return make("sphere", {{"radius", radius}}); }
inline Field cube() { return make("box", {{"size", Vec3d(8, 8, 8)}}); }
inline Value list(const std::vector<Field>& fields) {
  return ValueTraits<std::vector<Field>>::write(fields);
}

/// A cube of limestone below y = 0, of hardness 0.75, and of shale above, of hardness 0.
inline Field two_rocks(double contact = 0.1) {
  return make("host_rock", {{"field", as_value(cube())},
                            {"of", "shale"},
                            {"bodies", list({of(make("half_space", {}), "limestone", 0.75)})},
                            {"contact", contact}});
}

}  // namespace vug::field
