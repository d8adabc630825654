// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/simulation.h>
#include <vug/shot/cell_attributes.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace vug::shot {
namespace {

cells::Simulation few_cells() {
  static const cells::NetworkPtr few =
      std::make_shared<const cells::Network>(cells::flat_torus(4, 4, 4, 0.25));
  cells::Simulation simulation(few, RandomKey(0));
  simulation.set_trial(true);
  return simulation;
}

/// Runs the rules on a few cells to find out which attributes they create.
class TrialRun {
 public:
  explicit TrialRun(const CellsPlan& plan) : cells_(few_cells()) {
    for (const CellStagePtr& stage : plan.run) step(*stage);
    // A second run, in which rules find the attributes of later rules.
    faults_.clear();
    for (const CellStagePtr& stage : plan.run) step(*stage);
  }

  void report(Diagnostics& diagnostics) const {
    for (const auto& [where, error] : faults_) diagnostics.error(where, error.what(), error.hint());
  }
  const std::map<std::string, bool>& requested_attributes() const {
    return cells_.requested_attributes();
  }
  std::vector<std::string> names() const {
    std::vector<std::string> all = context_attribute_names();
    for (const cells::Attribute& each : cells_.attributes().all()) all.push_back(each.name);
    all.emplace_back(cells::kTransparent);
    return all;
  }
  bool creates(const std::string& name) const { return cells_.attributes().find(name); }

 private:
  void step(const CellStage& stage) {
    try {
      cells_.run({{stage.rule, stage.name, cells_.step(), 1}}, 1);
    } catch (const Error& error) {
      if (error.code() != ErrorCode::bad_input) throw;
      faults_.emplace_back(stage.location, error);
    }
  }

  cells::Simulation cells_;
  std::vector<std::pair<SourceLocation, Error>> faults_;
};

/// Describes why a name cannot be used in files; empty if it can.
std::string fault_of_name(const std::string& name) {
  static const std::set<std::string> kept = {
      "x", "y", "z", "nx", "ny", "nz", "red", "green", "blue", "alpha", "id", "pscale", "object"};
  const auto good = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  if (name.empty() || !std::all_of(name.begin(), name.end(), good) ||
      std::isdigit(static_cast<unsigned char>(name[0])) || name.size() > 100)
    return fmt::format("'{}' cannot be the name of an attribute", name);
  if (kept.count(name) > 0)
    return fmt::format("cells cannot create an attribute '{}': files reserve this name", name);
  return "";
}

}  // namespace

const std::vector<std::string>& context_attribute_names() {
  static const std::vector<std::string> names = {kExposure, kOcclusion, kCurvature};
  return names;
}

void resolve_attribute_names(CellsPlan& plan, Diagnostics& diagnostics) {
  const TrialRun trial_run(plan);
  trial_run.report(diagnostics);
  const std::vector<std::string> known = trial_run.names();
  std::set<std::string> named, reported;
  const auto check = [&](const std::string& name, const SourceLocation& where) {
    named.insert(name);
    if (std::find(known.begin(), known.end(), name) != known.end()) return;
    if (!plan.from.empty()) return;  // the points may provide it
    if (!reported.insert(to_string(where) + name).second) return;
    diagnostics.error(where,
                      fmt::format("no rule of '{}' creates an attribute '{}'", plan.name, name),
                      suggestion(name, known));
  };
  for (const CellStagePtr& stage : plan.run) {
    paint::AttributeUses uses = stage->rule->mask_attributes();
    if (stage->where)
      uses.insert(uses.end(), stage->where->uses().begin(), stage->where->uses().end());
    for (const paint::AttributeUse& use : uses) check(use.attribute, use.where);
    // For names inside a rule, only the location of the rule is known.
    cells::Simulation alone = few_cells();
    try {
      alone.run({{stage->rule, stage->name, 0, 1}}, 1);
    } catch (const Error&) {  // reported above
    }
    for (const auto& [name, needed] : alone.requested_attributes()) {
      named.insert(name);
      if (needed) check(name, stage->location);
    }
  }
  plan.attribute_names = known;
  for (const std::string& name : known)
    if (const std::string fault = fault_of_name(name); !fault.empty())
      diagnostics.error(plan.where, fault, "use letters, digits and _, without a leading digit");
  for (const std::string& name : context_attribute_names())
    if (named.count(name) > 0 && !trial_run.creates(name)) plan.context_attributes.push_back(name);
}

}  // namespace vug::shot
