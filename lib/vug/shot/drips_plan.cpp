// SPDX-License-Identifier: Apache-2.0
#include <vug/field/boolean.h>
#include <vug/field/deferred.h>
#include <vug/field/speleothems/deposits.h>
#include <vug/field/thickened.h>
#include <vug/shot/drips_plan.h>

namespace vug::shot {

DripsPlan::DripsPlan(const DripParams& params) : rock_(params.field), options_(params.options()) {
  drips::require_valid(options_.graph.edits, options_.graph);
}

const drips::Graph& DripsPlan::graph() const {
  const std::lock_guard lock(computing_);
  if (!graph_) graph_ = drips::build_graph(rock_, options_.graph);
  return *graph_;
}

const drips::Dripstone& DripsPlan::grown() const {
  const drips::Graph& drips = graph();
  const std::lock_guard lock(computing_);
  if (!grown_) grown_ = drips::grow_dripstone(rock_, drips, options_);
  return *grown_;
}

field::Field with_speleothems(const DripsPtr& drips, double root) {
  const drips::DripstoneOptions& options = drips->options();
  const Box3d bounds =
      drips::dripstone_bounds(drips->rock().bounds(), options.graph, options.forms);
  const double bytes = drips::graph_memory(options.graph);
  const field::Field solids = field::deferred(
      {drips::kDripstoneSlope, field::Exactness::sign, bounds, drips::kDripstoneGrowth},
      "finding drips", [drips] { return drips->grown().solids; }, bytes);
  const field::Field thickness = field::deferred(
      {field::kSteepestDeposit, field::Exactness::sign, infinite_box(), 0}, "laying flowstone",
      [drips] { return drips->grown().thickness; }, bytes);
  return field::unite({field::thickened(drips->rock(), thickness, field::kThickestDeposit), solids},
                      {field::Profile::smooth, root});
}

}  // namespace vug::shot
