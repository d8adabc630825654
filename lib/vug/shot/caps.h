// SPDX-License-Identifier: Apache-2.0
// Caps: walls of rock along the faces of a volume's region.
#pragma once

#include <vug/base/value_traits.h>
#include <vug/field/field.h>

#include <array>

namespace vug::shot {

/// The faces to close: -X, +X, -Y, +Y, -Z, +Z.
struct Caps {
  std::array<bool, 6> closed{};

  bool any() const { return closed != std::array<bool, 6>{}; }
};

/// The field and a wall of `thickness` metres behind each closed face of the box.
field::Field with_caps(const field::Field& field, const Caps& caps, const Box3d& box,
                       double thickness);

}  // namespace vug::shot

namespace vug {

/// A direction such as +X, or a list of directions.
template <>
struct ValueTraits<shot::Caps> {
  static std::string type() { return "list of directions"; }
  static std::optional<shot::Caps> read(const Value& v);
  static Value write(const shot::Caps& caps);
};

}  // namespace vug
