// SPDX-License-Identifier: Apache-2.0
// The solids of speleothems, which are computed on first use.
#pragma once

#include <vug/shot/drip_params.h>

#include <functional>
#include <vector>

namespace vug::shot {

/// The union of the forms that `grow` returns for drips with these parameters.
field::Field speleothem_field(const DripParams& params,
                              std::function<std::vector<drips::Form>()> grow);

}  // namespace vug::shot
