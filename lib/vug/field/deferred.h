// SPDX-License-Identifier: Apache-2.0
// Fields that are computed when they are first evaluated.
#pragma once

#include <vug/field/field.h>

#include <functional>

namespace vug::field {

/// The field that `make` returns. It is called once, when a value is first needed: a scene whose
/// text is only checked computes nothing. `traits` must hold for the result; its bounds may be
/// larger. Interval evaluation gives bounds from the traits alone, and the expression is a leaf
/// until it has been computed. Thread-safe, even if `make` runs a parallel loop.
Field deferred(Traits traits, std::function<Field()> make);

}  // namespace vug::field
