// SPDX-License-Identifier: Apache-2.0
#include <vug/modeller/plans.h>

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace vug::modeller {

using facade::InfeasiblePlan;
using facade::Plan;
using facade::PlanPtr;

namespace {

std::string node_text(const FacadeState& state, int node) {
  return node == FacadeState::kWhole
             ? "the facade"
             : fmt::format("'{}' at {}", state.node(node).symbol, state.path(node));
}

/// Drops or reduces one number, see with_feasible_numbers; false if the number is not the cause.
bool without(Plan& plan, const std::string& name, const facade::NumberValues& needed) {
  const auto found = plan.numbers.find(name);
  if (found == plan.numbers.end() || needed.count(name)) return false;
  std::vector<double>& values = found->second;
  if (values.size() > 1)
    values = {std::accumulate(values.begin(), values.end(), 0.0) /
              static_cast<double>(values.size())};
  else
    plan.numbers.erase(found);
  return true;
}

/// `plan` with `part` in place of its only part.
Plan with_part(const Plan& plan, const Plan& part) {
  Plan out = plan;
  out.parts.begin()->second = std::make_shared<const Plan>(part);
  return out;
}

}  // namespace

void require_open(const FacadeState& state, int node) {
  if (node == FacadeState::kWhole)
    throw edit_error("the facade itself has no rules", "its axiom is node 0");
  if (state.rule(node) >= 0)
    throw InfeasiblePlan(facade::Reason::divided, "",
                         fmt::format("{} is already divided, by {}", node_text(state, node),
                                     state.style().rule_name(state.rule(node))),
                         "retract or change that rule");
  if (state.node(node).element)
    throw edit_error(fmt::format("{} is an element", node_text(state, node)),
                     "elements are not divided further");
  if (!state.node(node).stuck)
    throw edit_error(fmt::format("{} is part of a rule, which divides it", node_text(state, node)));
}

void require_divided(const FacadeState& state, int node) {
  if (node == FacadeState::kWhole) return;
  const facade::Node& it = state.node(node);
  if (it.stuck || it.element)
    throw edit_error(fmt::format("{} is not divided", node_text(state, node)),
                     it.stuck ? "apply a rule first" : "it is an element");
}

PlanPtr plan_of(int rule, const facade::NumberValues& numbers) {
  Plan out;
  out.rule = rule;
  for (const auto& [name, values] : numbers)
    if (!values.empty()) out.numbers[name] = values;
  return std::make_shared<const Plan>(std::move(out));
}

FacadeState first_feasible(const FacadeState& state, int node, const std::vector<PlanPtr>& plans) {
  std::exception_ptr first;
  for (const PlanPtr& plan : plans) {
    try {
      return state.with(node, plan);
    } catch (const InfeasiblePlan&) {
      if (!first) first = std::current_exception();
    }
  }
  if (first) std::rethrow_exception(first);
  throw Error(ErrorCode::internal, "there is no plan to choose from");
}

PlanPtr translated(const Style& style, const PlanPtr& plan, const std::string& symbol) {
  if (!plan || plan->rule < 0) return plan;
  const facade::Rule& rule = style.rule(plan->rule);
  if (rule.head == symbol) return plan;
  for (const int each : style.rules_of(symbol))
    if (style.rule_name(each) == style.rule_name(plan->rule)) {
      Plan out = *plan;
      out.rule = each;
      return std::make_shared<const Plan>(std::move(out));
    }
  return nullptr;
}

FacadeState with_feasible_numbers(const FacadeState& state, int node, Plan plan,
                                  const facade::NumberValues& needed) {
  // If a rule passes its rectangle on, its numbers are in the plan of that part.
  const bool handed = plan.rule >= 0 && state.style().passes_to(plan.rule) && !plan.parts.empty();
  Plan inner = handed && plan.parts.begin()->second ? *plan.parts.begin()->second : Plan();
  while (true) {
    const Plan whole = handed ? with_part(plan, inner) : plan;
    try {
      return state.with(node, std::make_shared<const Plan>(whole));
    } catch (const InfeasiblePlan& error) {
      if (!without(handed ? inner : plan, error.number(), needed)) throw;
    }
  }
}

facade::NumberValues merged(facade::NumberValues numbers, const facade::NumberValues& changes) {
  for (const auto& [name, values] : changes) {
    if (values.empty())
      numbers.erase(name);
    else
      numbers[name] = values;
  }
  return numbers;
}

bool has_cells(const FacadeState& state, int node) {
  std::set<std::pair<int, int>> places;
  const std::vector<int> parts = state.parts(node);
  for (const int part : parts) {
    if (!state.node(part).copies.empty()) return false;
    const facade::PartKey& place = state.planned(part).place;
    if (place.row >= 0) places.insert({place.column, place.row});
  }
  const auto& off = state.plan_of_node(node).off;
  return places.size() + off.size() > 1 || !off.empty();
}

}  // namespace vug::modeller
