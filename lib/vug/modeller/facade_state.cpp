// SPDX-License-Identifier: Apache-2.0
#include <vug/modeller/facade_state.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::modeller {

namespace {

using facade::PartKey;
using facade::Plan;
using facade::PlanPtr;

Plan replaced(const Plan& plan, const std::vector<PartKey>& keys, size_t at, const PlanPtr& part,
              bool alone) {
  Plan out = plan;
  if (alone) out.parts.clear();
  const auto known = plan.parts.find(keys[at]);
  static const Plan nothing;
  const PlanPtr made =
      at + 1 == keys.size()
          ? part
          : std::make_shared<const Plan>(replaced(
                known == plan.parts.end() ? nothing : *known->second, keys, at + 1, part, alone));
  if (made)
    out.parts[keys[at]] = made;
  else
    out.parts.erase(keys[at]);
  return out;
}

}  // namespace

FacadeState::FacadeState(StylePtr style, const Canvas& canvas)
    : FacadeState(std::move(style), canvas, Plan()) {}

FacadeState::FacadeState(StylePtr style, const Canvas& canvas, Plan plan) {
  for (const double size : {canvas.width, canvas.height, canvas.min_size})
    if (!(size > 0) || !(size < 1e6))
      throw Error(ErrorCode::bad_input,
                  fmt::format("invalid facade of {} x {} m with a minimum part size of {} m",
                              canvas.width, canvas.height, canvas.min_size),
                  {}, "sizes must be above 0 and below 1000 km");
  if (canvas.min_size > std::min(canvas.width, canvas.height))
    throw Error(ErrorCode::bad_input,
                fmt::format("a facade of {} x {} m is smaller than the minimum part size, {} m",
                            canvas.width, canvas.height, canvas.min_size));
  facade::DeriveOptions options{.width = canvas.width, .height = canvas.height};
  options.limits = {canvas.max_symbols, canvas.max_symbols};
  options.key = RandomKey(canvas.seed).at("grammar").at(style->name());
  facade::PlannedDerivation made = style->derive(options, {plan, canvas.min_size});
  inner_ = std::make_shared<const Inner>(Inner{std::move(style), canvas, std::move(plan),
                                               std::move(made.derived.tree), std::move(made.root),
                                               std::move(made.nodes)});
}

const facade::PlannedNode& FacadeState::planned(int index) const {
  return index == kWhole ? inner_->root : inner_->nodes.at(static_cast<size_t>(index));
}

const Plan& FacadeState::plan_of_node(int index) const {
  static const Plan nothing;
  const PlanPtr& plan = planned(index).plan;
  return plan ? *plan : nothing;
}

std::vector<int> FacadeState::open() const {
  std::vector<int> out;
  for (size_t i = 0; i < tree().nodes.size(); ++i)
    if (tree().nodes[i].stuck) out.push_back(static_cast<int>(i));
  return out;
}

std::vector<PartKey> FacadeState::path_keys(int index) const {
  std::vector<PartKey> out;
  for (int at = index; at >= 0; at = node(at).parent) out.push_back(planned(at).place);
  std::reverse(out.begin(), out.end());
  return out;
}

int FacadeState::at(const std::vector<PartKey>& keys) const {
  int found = kWhole;
  for (const PartKey& place : keys) {
    const std::vector<int> all = parts(found);
    const auto next = std::find_if(all.begin(), all.end(),
                                   [&](int part) { return planned(part).place == place; });
    if (next == all.end()) return kWhole;
    found = *next;
  }
  return found;
}

std::vector<int> FacadeState::parts(int index) const {
  if (index != kWhole) return node(index).children;
  std::vector<int> out;
  for (size_t i = 0; i < tree().nodes.size(); ++i)
    if (tree().nodes[i].parent < 0) out.push_back(static_cast<int>(i));
  return out;
}

FacadeState FacadeState::with(int index, PlanPtr plan) const {
  if (index == kWhole) return with(plan ? *plan : Plan());
  return with(replaced(inner_->plan, path_keys(index), 0, plan, false));
}

FacadeState FacadeState::with(Plan whole) const {
  return FacadeState(inner_->style, inner_->canvas, std::move(whole));
}

Plan FacadeState::isolated_plan(int index, PlanPtr plan) const {
  if (index == kWhole) return plan ? *plan : Plan();
  return replaced(inner_->plan, path_keys(index), 0, plan, true);
}

}  // namespace vug::modeller
