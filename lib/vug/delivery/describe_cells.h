// How even a scene's cells are and how they are linked, as data.
#pragma once

#include <vug/building/builder.h>

#include <nlohmann/json_fwd.hpp>

namespace vug::delivery {

/// The cells of that name: how many on which meshes, the pieces that links join them to, distances
/// to the nearest cell before and after harmonising, how many cells have how many links, and the
/// states that the run has left. Error(bad_input) where the shot has none of that name.
nlohmann::ordered_json describe_cells(building::Builder& builder, const std::string& name);

}  // namespace vug::delivery
