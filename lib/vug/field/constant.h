// SPDX-License-Identifier: Apache-2.0
// A constant field.
#pragma once

#include <vug/field/field.h>

namespace vug::field {

/// `value` metres at every point; `bounds` depends on its sign.
Field constant_field(double value);

}  // namespace vug::field
