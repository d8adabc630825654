// SPDX-License-Identifier: Apache-2.0
// Rock below a deposit whose thickness is a function of space.
#pragma once

#include <vug/field/field.h>

namespace vug::field {

/// The rock with a layer on its surface: rock(p) - thickness(p). `thickness` has values of 0 to
/// `most` metres; where it is 0 the rock keeps its values, and evaluation costs no more. Elsewhere
/// values are Lipschitz but do not bound the distance.
Field thickened(const Field& rock, const Field& thickness, double most);

}  // namespace vug::field
