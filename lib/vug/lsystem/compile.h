// SPDX-License-Identifier: Apache-2.0
// Compilation of an L-system's text into a System.
#pragma once

#include <vug/lsystem/options.h>
#include <vug/lsystem/system.h>
#include <vug/scene/lsystem_document.h>

#include <functional>
#include <string>
#include <vector>

namespace vug::lsystem {

/// Looks up the L-system of that name, which a module may refer to; null if it does not exist or
/// has errors.
using FindSystem = std::function<SystemPtr(const std::string& name, const SourceLocation& where)>;

/// Compiles the block; null, with diagnostics, if the text has errors. Expressions without formals
/// and random choices are evaluated here. Warns of rules that can never apply.
SystemPtr compile(const scene::Grammar& grammar, const SystemOptions& options,
                  scene::Evaluator& evaluator, const FindSystem& find);

/// Compiles the block with the options that it sets: see system_options.
SystemPtr compile(const scene::Grammar& grammar, scene::Evaluator& evaluator,
                  const FindSystem& find);

}  // namespace vug::lsystem
