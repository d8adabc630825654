// SPDX-License-Identifier: Apache-2.0
// Bonds and labels, which define where and how two shapes can be joined (zawadzki2012, definitions
// 4 and 5).
#pragma once

#include <vug/base/rng.h>
#include <vug/base/vec.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::sgm {

/// The side of the base that a production grows on (the paper's L_B parameter).
enum class Label { minus_x, plus_x, minus_y, plus_y, minus_z, plus_z, random };

/// "-X", "+X", ..., "random".
std::string to_string(Label label);
/// Parses a label in upper or lower case; returns nothing for other text.
std::optional<Label> label_from(const std::string& text);
/// The names of all labels, for messages.
std::vector<std::string> label_names();

/// Outward unit vector of a side; undefined for `random`.
Vec3d direction(Label side);
Label opposite(Label side);
/// The side itself, or for `random` one of the six with equal probability.
Label sample_side(Label label, RandomKey key);

/// Definition 4, B = (P, D): a point on a shape's surface, in metres, and the outward unit
/// direction in which it can be joined. D = 0 allows any direction.
struct Bond {
  Vec3d point{0, 0, 0};
  Vec3d direction{0, 0, 0};

  bool free_direction() const { return direction == Vec3d(0); }
};

/// Whether the bond belongs to a side: the largest component of its direction points there (the
/// first of x, y, z among equal ones). A bond with D = 0 belongs to every side.
bool on_side(const Bond& bond, Label side);

/// Definition 5: the points coincide, and the directions are opposite or one of them is 0. Points
/// may differ by `tolerance` times `size` (metres, of the shape), directions by `tolerance`.
bool makes_label(const Bond& a, const Bond& b, double size, double tolerance = 1e-6);

}  // namespace vug::sgm
