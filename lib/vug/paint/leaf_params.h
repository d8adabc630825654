// SPDX-License-Identifier: Apache-2.0
// Internal header of paint/: parameters shared by the leaf masks.
#pragma once

#include <vug/paint/kind.h>
#include <vug/paint/leaf_pattern.h>

#include <optional>

namespace vug::paint {

struct LeafParams {
  double widest = LeafOutline().widest;
  double tip = LeafOutline().tip;

  LeafOutline outline() const { return {widest, tip}; }
};

/// Adds the parameters that leaf(...) has, too; both must have the same values.
template <class P>
void describe_outline(Schema<P>& s) {
  s.param("widest", &LeafParams::widest,
          {.doc = "fraction of the length where the leaf is widest", .min = 0.05, .max = 0.95})
      .param("tip", &LeafParams::tip,
             {.doc = "the larger, the longer and finer the tip", .min = 0.1, .max = 10});
}

/// Empty on meshes without leaf coordinates.
inline std::optional<LeafPoint> leaf_point(const EvalPoint& point) {
  if (!point.attributes) return std::nullopt;
  const auto across = point.attributes->read(kLeafAcross),
             along = point.attributes->read(kLeafAlong);
  if (!across || !along) return std::nullopt;
  return LeafPoint{across->x, along->x};
}

}  // namespace vug::paint
