#include <vug/modeller/state.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::modeller {

namespace {

using facade::PartKey;
using facade::Plan;
using facade::PlanPtr;

Plan replaced(const Plan& plan, const std::vector<PartKey>& way, size_t at, const PlanPtr& part,
              bool alone) {
  Plan out = plan;
  if (alone) out.parts.clear();
  const auto known = plan.parts.find(way[at]);
  static const Plan nothing;
  const PlanPtr made =
      at + 1 == way.size()
          ? part
          : std::make_shared<const Plan>(replaced(
                known == plan.parts.end() ? nothing : *known->second, way, at + 1, part, alone));
  if (made)
    out.parts[way[at]] = made;
  else
    out.parts.erase(way[at]);
  return out;
}

}  // namespace

State::State(StylePtr style, const Sheet& sheet) : State(std::move(style), sheet, Plan()) {}

State::State(StylePtr style, const Sheet& sheet, Plan plan) {
  for (const double size : {sheet.width, sheet.height, sheet.least})
    if (!(size > 0) || !(size < 1e6))
      throw Error(ErrorCode::bad_input,
                  fmt::format("a facade of {} x {} m whose parts are {} m or more", sheet.width,
                              sheet.height, sheet.least),
                  {}, "sizes are above 0 and below 1000 km");
  if (sheet.least > std::min(sheet.width, sheet.height))
    throw Error(ErrorCode::bad_input,
                fmt::format("a facade of {} x {} m is smaller than its least part, {} m",
                            sheet.width, sheet.height, sheet.least));
  facade::DeriveOptions options{.width = sheet.width, .height = sheet.height};
  options.limits = {sheet.limit, sheet.limit};
  options.key = RandomKey(sheet.seed).at("grammar").at(style->name());
  facade::PlannedDerivation made = style->derive(options, {plan, sheet.least});
  inner_ = std::make_shared<const Inner>(Inner{std::move(style), sheet, std::move(plan),
                                               std::move(made.derived.tree), std::move(made.root),
                                               std::move(made.nodes)});
}

const facade::PlannedNode& State::planned(int index) const {
  return index == kWhole ? inner_->root : inner_->nodes.at(static_cast<size_t>(index));
}

const Plan& State::decided(int index) const {
  static const Plan nothing;
  const PlanPtr& plan = planned(index).plan;
  return plan ? *plan : nothing;
}

std::vector<int> State::open() const {
  std::vector<int> out;
  for (size_t i = 0; i < tree().nodes.size(); ++i)
    if (tree().nodes[i].stuck) out.push_back(static_cast<int>(i));
  return out;
}

std::vector<PartKey> State::way(int index) const {
  std::vector<PartKey> out;
  for (int at = index; at >= 0; at = node(at).parent) out.push_back(planned(at).place);
  std::reverse(out.begin(), out.end());
  return out;
}

int State::at(const std::vector<PartKey>& way) const {
  int found = kWhole;
  for (const PartKey& place : way) {
    const std::vector<int> all = parts(found);
    const auto next = std::find_if(all.begin(), all.end(),
                                   [&](int part) { return planned(part).place == place; });
    if (next == all.end()) return kWhole;
    found = *next;
  }
  return found;
}

std::vector<int> State::parts(int index) const {
  if (index != kWhole) return node(index).children;
  std::vector<int> out;
  for (size_t i = 0; i < tree().nodes.size(); ++i)
    if (tree().nodes[i].parent < 0) out.push_back(static_cast<int>(i));
  return out;
}

State State::with(int index, PlanPtr plan) const {
  if (index == kWhole) return with(plan ? *plan : Plan());
  return with(replaced(inner_->plan, way(index), 0, plan, false));
}

State State::with(Plan whole) const {
  return State(inner_->style, inner_->sheet, std::move(whole));
}

Plan State::alone(int index, PlanPtr plan) const {
  if (index == kWhole) return plan ? *plan : Plan();
  return replaced(inner_->plan, way(index), 0, plan, true);
}

}  // namespace vug::modeller
