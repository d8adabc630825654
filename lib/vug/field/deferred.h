// SPDX-License-Identifier: Apache-2.0
// Fields that are computed when they are first evaluated.
#pragma once

#include <vug/base/progress.h>
#include <vug/field/field.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <string>

namespace vug::field {

/// The field that `make` returns. It is called once, when a value is first needed: a scene whose
/// text is only checked computes nothing. `traits` must hold for the result; its bounds may be
/// larger. Interval evaluation gives bounds from the traits alone, and the expression is a leaf
/// until it has been computed. Thread-safe, even if `make` runs a parallel loop. `work`: what
/// `make` does, as the name of a stage. `bytes`: the memory that it needs.
Field deferred(Traits traits, std::string work, std::function<Field()> make, double bytes = 0);

/// Computes the deferred fields in `whole` that have not been evaluated, each as a stage. Throws
/// Error(too_large) if one needs more memory than `memory` bytes.
void compute_deferred(const Field& whole, Progress& progress,
                      uint64_t memory = std::numeric_limits<uint64_t>::max());

}  // namespace vug::field
