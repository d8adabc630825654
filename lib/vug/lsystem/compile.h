// An L-system's text made into a system.
#pragma once

#include <vug/lsystem/system.h>
#include <vug/scene/evaluator.h>
#include <vug/scene/lsystem_document.h>

#include <functional>
#include <string>
#include <vector>

namespace vug::lsystem {

/// The L-system of that name, which a module may stand for; null where there is none (or none
/// without faults).
using FindSystem = std::function<SystemPtr(const std::string& name, const SourceLocation& where)>;

/// Options of a block that systems read: the others are the turtle's.
///   steps  whole number, 1 by default        time   of systems whose modules age, from 0 on
///   limit  modules at most, 10 million       seed   whole number: in place of the scene's
const std::vector<std::string>& system_options();

/// Null, with diagnostics, for a text at fault. Expressions without formals and draws are evaluated
/// here. Warns of rules that nothing can make apply.
SystemPtr compile(const scene::Grammar& grammar, scene::Evaluator& evaluator,
                  const FindSystem& find);

}  // namespace vug::lsystem
