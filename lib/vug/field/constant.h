// A field with one value everywhere.
#pragma once

#include <vug/field/field.h>

namespace vug::field {

/// `value` metres at every point; `bounds` as for its sign.
Field constant_field(double value);

}  // namespace vug::field
