// SPDX-License-Identifier: Apache-2.0
// A field with the values of another one times a positive factor.
#pragma once

#include <vug/field/field.h>

namespace vug::field {

/// The field itself for the factor 1.
Field scaled_values(const Field& field, double factor);

}  // namespace vug::field
