// SPDX-License-Identifier: Apache-2.0
// Conversion of fitted trees from pixels to facade trees in metres, with default dimensions of
// elements.
#pragma once

#include <vug/base/vec.h>
#include <vug/facade/rules.h>
#include <vug/facade/tree.h>
#include <vug/fit/model/model.h>

namespace vug::fit {

/// Converts the tree with a pixel size in metres along x and y; the origin is the lower left corner
/// of the picture. `text` holds the rules that the model's rules were compiled from. Elements have
/// their default dimensions. Windows covered by a door and window kinds without instances are
/// omitted. The state's areas must be valid (see Model::compute_areas).
facade::Tree to_facade_tree(const facade::Rules& text, const Model& model, const TreeState& state,
                            const Vec2d& pixel);

}  // namespace vug::fit
