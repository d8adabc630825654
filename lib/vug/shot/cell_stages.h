// SPDX-License-Identifier: Apache-2.0
// Cell rules as called in a scene, with their steps and masks.
#pragma once

#include <vug/base/kind.h>
#include <vug/shot/cells_plan.h>

namespace vug::shot {

/// The kinds of cells::rules() with the additional parameters `begin`, `steps` and `where`.
const Kinds<CellStagePtr>& cell_stages();

/// The stage kind of one rule, which must outlive it.
Kind<CellStagePtr> stage_kind(const cells::RuleKind& rule);

}  // namespace vug::shot

namespace vug {

template <>
struct ValueTraits<shot::CellStagePtr> : ObjectTraits<shot::CellStagePtr> {
  static constexpr const char* kWord = "rule";
};

}  // namespace vug
