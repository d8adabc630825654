// SPDX-License-Identifier: Apache-2.0
// Nodes whose thickness varies along their length, such as the passages of a cave.
#pragma once

#include <vug/base/vec.h>

#include <optional>

namespace vug::field {

class VariesInThickness {
 public:
  /// The parts of the node that are thinner than a length.
  struct Thin {
    double share = 0;      ///< The fraction of the whole length, 0..1.
    double thickness = 0;  ///< The least, in metres.
    Vec3d at{0.0};         ///< The place of the least, in the space of the node.
  };

  virtual ~VariesInThickness() = default;
  /// Nothing if no part is thinner than `thickness` metres.
  virtual std::optional<Thin> thinner_than(double thickness) const = 0;

 protected:
  VariesInThickness() = default;
  VariesInThickness(const VariesInThickness&) = default;
  VariesInThickness& operator=(const VariesInThickness&) = default;
};

}  // namespace vug::field
