// SPDX-License-Identifier: Apache-2.0
#include <vug/field/blend.h>

namespace vug::field {

double Blend::depth() const { return profile == Profile::sharp ? 0 : radius * kernel(1.0); }

}  // namespace vug::field
