// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/field/boolean.h>
#include <vug/field/deferred.h>
#include <vug/field/grown_material.h>
#include <vug/field/speleothems/deposits.h>
#include <vug/field/thickened.h>
#include <vug/shot/drips_plan.h>

namespace vug::shot {

DripsPlan::DripsPlan(const DripParams& params) : rock_(params.field), options_(params.options()) {
  drips::require_valid(options_.graph.edits, options_.graph);
  drips::require_below_roof(options_.graph.edits, rock_, options_.graph);
}

const drips::Graph& DripsPlan::graph() const {
  const std::lock_guard lock(computing_);
  return whole_graph();
}

const drips::Graph& DripsPlan::whole_graph() const {
  const auto make = [&] { return drips::build_graph(rock_, options_.graph); };
  if (!graph_) graph_ = cache_ ? cache_->graph(digest(), make) : make();
  return *graph_;
}

drips::GrownForms DripsPlan::grow() const {
  if (options_.flowstone.share > 0) return drips::grow_forms(rock_, whole_graph(), options_);
  // Nothing grows along films on floors. The whole graph is not used even if it is known, so that
  // what grows does not depend on what else was asked of the plan.
  drips::GraphOptions options = options_.graph;
  options.over_floors = false;
  return drips::grow_forms(rock_, drips::build_graph(rock_, options), options_);
}

const drips::Dripstone& DripsPlan::grown() const {
  const std::lock_guard lock(computing_);
  const auto make = [&] { return grow(); };
  if (!grown_)
    grown_ = drips::with_fields(cache_ ? cache_->forms(digest(), make) : make(), options_);
  return *grown_;
}

void DripsPlan::keep_in(std::shared_ptr<DripsCache> cache) const {
  const std::lock_guard lock(computing_);
  cache_ = std::move(cache);
}

field::Field with_speleothems(const DripsPtr& drips, const SpeleothemJoin& join,
                              SpeleothemPart part) {
  const drips::DripstoneOptions& options = drips->options();
  const Box3d bounds =
      drips::dripstone_bounds(drips->rock().bounds(), options.graph, options.forms);
  const double bytes = drips::graph_memory(options.graph);
  const field::Field solids = field::deferred(
      {drips::kDripstoneSlope, field::Exactness::sign, bounds, drips::kDripstoneGrowth},
      {"finding drips", bytes}, [](const DripsPtr& plan) { return plan->grown().solids; }, drips);
  const field::Field own = field::of_material(solids, join.material);
  if (part == SpeleothemPart::solids) return own;
  const field::Field thickness = field::deferred(
      {field::kSteepestDeposit, field::Exactness::sign, infinite_box(), 0},
      {"laying flowstone", bytes}, [](const DripsPtr& plan) { return plan->grown().thickness; },
      drips);
  const field::Field thick = field::thickened(drips->rock(), thickness, field::kThickestDeposit),
                     rock = field::grown_on(drips->rock(), thick, join.material);
  if (part == SpeleothemPart::rock) return rock;
  return field::unite({rock, own}, field::Blend{field::Profile::smooth, join.root});
}

}  // namespace vug::shot
