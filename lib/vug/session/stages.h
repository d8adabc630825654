// Rules of cells as a scene calls them: each with when and where it works.
#pragma once

#include <vug/base/kind.h>
#include <vug/session/cells_plan.h>

namespace vug::session {

/// The kinds of cells::rules(), whose parameters are followed by `begin`, `steps` and `where`.
const Kinds<CellStagePtr>& cell_stages();

/// The same of one, which must outlive it.
Kind<CellStagePtr> as_stage(const cells::RuleKind& rule);

}  // namespace vug::session

namespace vug {

template <>
struct ValueTraits<session::CellStagePtr> : ObjectTraits<session::CellStagePtr> {
  static constexpr const char* kWord = "rule";
};

}  // namespace vug
