// SPDX-License-Identifier: Apache-2.0
#include <vug/modeller/query.h>

#include <fmt/format.h>

namespace vug::modeller {

using facade::Placement;
using facade::Plan;
using facade::Reason;
using facade::Rect;

namespace {

RuleChoice inapplicable(int rule, Reason reason, std::string why, std::string hint = {}) {
  return {.rule = rule, .reason = reason, .why = std::move(why), .hint = std::move(hint)};
}

}  // namespace

RuleChoice evaluate_rule(const FacadeState& state, int node, int rule,
                         const facade::NumberValues& numbers) {
  const std::string symbol = node == FacadeState::kWhole ? "" : state.node(node).symbol;
  const Style& style = state.style();
  if (symbol != style.rule(rule).head)
    return inapplicable(rule, Reason::wrong_symbol,
                        fmt::format("it divides '{}'", style.rule(rule).head));
  if (state.rule(node) >= 0) {
    RuleChoice out =
        inapplicable(rule, Reason::divided,
                     state.rule(node) == rule
                         ? "it divides the node"
                         : fmt::format("{} divides the node", style.rule_name(state.rule(node))));
    out.applied = state.rule(node) == rule;
    if (out.applied) out.free = state.planned(node).free;
    return out;
  }
  Plan plan;
  plan.rule = rule;
  plan.numbers = numbers;
  try {
    const FacadeState tried =
        state.with(state.isolated_plan(node, std::make_shared<const Plan>(plan)));
    return {.rule = rule, .free = tried.planned(tried.at(state.path_keys(node))).free};
  } catch (const facade::InfeasiblePlan& error) {
    return inapplicable(rule, error.reason(), error.what(), error.hint());
  } catch (const Error& error) {
    if (error.code() != ErrorCode::bad_input && error.code() != ErrorCode::too_large) throw;
    return inapplicable(rule, Reason::does_not_fit, error.what(), error.hint());
  }
}

std::vector<RuleChoice> choices(const FacadeState& state, int node) {
  std::vector<RuleChoice> out;
  if (node == FacadeState::kWhole) return out;
  for (const int rule : state.style().rules_of(state.node(node).symbol))
    out.push_back(evaluate_rule(state, node, rule));
  return out;
}

std::vector<RuleChoice> all_choices(const FacadeState& state, int node) {
  std::vector<RuleChoice> out;
  for (size_t i = 0; i < state.style().rules().rules.size(); ++i)
    out.push_back(evaluate_rule(state, node, static_cast<int>(i)));
  return out;
}

std::vector<ActionChoice> actions(const FacadeState& state, int node) {
  std::vector<ActionChoice> out;
  for (const Action& action : state.style().actions()) {
    ActionChoice best{&action, evaluate_rule(state, node, action.rules.front())};
    for (const int rule : action.rules) {
      const RuleChoice choice = evaluate_rule(state, node, rule);
      const bool nearer = best.choice.reason == Reason::wrong_symbol;
      if (choice.reason == Reason::none || (nearer && choice.reason != Reason::wrong_symbol))
        best.choice = choice;
      if (choice.reason == Reason::none) break;
    }
    out.push_back(std::move(best));
  }
  return out;
}

std::optional<Hit> hit(const FacadeState& state, double x, double y) {
  const auto inside = [&](const Rect& r) {
    return x >= r.x && x <= r.right() && y >= r.y && y <= r.top();
  };
  int at = FacadeState::kWhole;
  Placement placement;
  while (true) {
    int next = FacadeState::kWhole;
    Placement its;
    for (const int part : state.parts(at)) {
      const facade::Node& node = state.node(part);
      std::vector<Placement> places = {{}};
      places.insert(places.end(), node.copies.begin(), node.copies.end());
      for (const Placement& place : places)
        if (inside(placement.after(place)(node.rect))) {
          next = part;
          its = placement.after(place);
        }
    }
    if (next == FacadeState::kWhole) break;
    at = next;
    placement = its;
  }
  if (at == FacadeState::kWhole) return std::nullopt;
  const Rect& own = state.node(at).rect;
  const Rect seen = placement(own);
  const bool turned = placement.mirrored != state.planned(at).mirrored;
  return Hit{at, placement, turned ? seen.right() - x : x - seen.x, y - seen.y};
}

}  // namespace vug::modeller
