// Rules of cells as a scene calls them: each with when and where it works.
#pragma once

#include <vug/base/kind.h>
#include <vug/shot/cells_plan.h>

namespace vug::shot {

/// The kinds of cells::rules(), whose parameters are followed by `begin`, `steps` and `where`.
const Kinds<CellStagePtr>& cell_stages();

/// The same of one, which must outlive it.
Kind<CellStagePtr> stage_kind(const cells::RuleKind& rule);

}  // namespace vug::shot

namespace vug {

template <>
struct ValueTraits<shot::CellStagePtr> : ObjectTraits<shot::CellStagePtr> {
  static constexpr const char* kWord = "rule";
};

}  // namespace vug
