// SPDX-License-Identifier: Apache-2.0
// Statistics of the spacing and the links of cells, as data.
#pragma once

#include <vug/building/builder.h>

#include <nlohmann/json_fwd.hpp>

namespace vug::delivery {

/// Describes the cells of that name: their number on each mesh, connected components, distances to
/// the nearest cell before and after relaxation, a histogram of the number of links, and the states
/// after the run. Error(bad_input) if the shot has no cells of that name.
nlohmann::ordered_json describe_cells(building::Builder& builder, const std::string& name);

}  // namespace vug::delivery
