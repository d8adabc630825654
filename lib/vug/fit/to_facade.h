// From pixels back to metres: a fitted tree as everything else knows facades.
#pragma once

#include <vug/base/vec.h>
#include <vug/facade/rules.h>
#include <vug/facade/tree.h>
#include <vug/fit/model/model.h>

namespace vug::fit {

/// The tree with pixels of so many metres across and up; the picture's lower left corner is the
/// origin. `text` is what the model's rules were compiled from. Elements have the measures that
/// they have by default. Windows that a door stands before are left out, and so are kinds of
/// windows that stand nowhere. The state's areas must hold (see Model::place).
facade::Tree to_facade_tree(const facade::Rules& text, const Model& model, const TreeState& state,
                            const Vec2d& pixel);

}  // namespace vug::fit
