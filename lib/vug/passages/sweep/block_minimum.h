// SPDX-License-Identifier: Apache-2.0
// Internal to passages/: the minimum over the segments of an active set in a block of voxels, near
// the surface.
#pragma once

#include <vug/field/near_surface.h>
#include <vug/passages/sweep/active_set.h>

namespace vug::passages {

/// Upper bounds include the rounding of batches in single precision, as Node::centre_form does.
inline double tolerance(const Vec3d& p, double radius) { return 1e-6 * (1 + p.length() + radius); }

/// A block of voxels in which the sweep's values up to a limit matter.
struct BlockTask {
  const SweepParts& parts;
  const field::LatticeBlock& block;
  double limit;
  field::Scratch& scratch;
};

/// The results of NearSurface::first_order for the segments of a set, which needs no links.
field::BlockRange first_order_minimum(const BlockTask& task, const ActiveSet& set,
                                      const field::FirstOrderRuns& out);

/// Where |value| <= limit, only segments whose value is at most `limit` matter, and those within
/// the radius k of a joint of the minimum of its arms, which is at most the value + k / 4.
inline double limit_with_fillet(double limit, double fillet) {
  return limit + (1 + field::Blend{field::Profile::smooth, 1}.depth()) * fillet;
}

}  // namespace vug::passages
