// An L-system's text made into a system.
#pragma once

#include <vug/lsystem/options.h>
#include <vug/lsystem/system.h>
#include <vug/scene/lsystem_document.h>

#include <functional>
#include <string>
#include <vector>

namespace vug::lsystem {

/// The L-system of that name, which a module may stand for; null where there is none (or none
/// without faults).
using FindSystem = std::function<SystemPtr(const std::string& name, const SourceLocation& where)>;

/// Null, with diagnostics, for a text at fault. Expressions without formals and draws are evaluated
/// here. Warns of rules that nothing can make apply.
SystemPtr compile(const scene::Grammar& grammar, const SystemOptions& options,
                  scene::Evaluator& evaluator, const FindSystem& find);

/// The same with the options that stand in the block: see system_options.
SystemPtr compile(const scene::Grammar& grammar, scene::Evaluator& evaluator,
                  const FindSystem& find);

}  // namespace vug::lsystem
