// SPDX-License-Identifier: Apache-2.0
// The clauses of an item of a shape grammar, e.g. `label +X`; options of the grammar are defaults.
#pragma once

#include <vug/loading/rule_values.h>
#include <vug/sgm/production_step.h>

namespace vug::loading {

/// The clause of a shape that connects two places.
inline constexpr const char* kConnectClause = "connect";

/// The values of all clauses; `step` has no pieces yet.
struct ItemClauses {
  sgm::ProductionStep step;
  int pieces = 1;
};

/// All clauses. Every one but `connect` is an option of the grammar, too.
std::vector<ParamInfo> clause_infos();

/// Whether there is a clause of that name.
bool is_clause(const std::string& name);

/// Whether a clause has an effect on a shape that is placed on a network or connects two places: it
/// does not describe how a shape is glued to another one.
bool applies_without_glue(const std::string& clause);

/// Reads one clause. Reports unknown names and unsuitable values.
void read_clause(const scene::Entry& clause, RandomKey key, const scene::Scope& scope,
                 const RuleValues& values, ItemClauses& out);

}  // namespace vug::loading
