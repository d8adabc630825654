// SPDX-License-Identifier: Apache-2.0
// Places that a grammar names, for cameras, lamps and figures.
#pragma once

#include <vug/field/field.h>

#include <string>
#include <vector>

namespace vug::sgm {

struct NamedPlace {
  std::string name;
  Vec3d position{0.0};  ///< The middle of the shape that has the name.
};

/// The same field with places, which only the result itself has, not an expression of it.
field::Field with_places(const field::Field& field, std::vector<NamedPlace> places);

/// The places of a result of `with_places`, in the order of the derivation; of other fields, none.
const std::vector<NamedPlace>& places_of(const field::Field& field);

}  // namespace vug::sgm
