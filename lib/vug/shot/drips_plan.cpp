// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/field/boolean.h>
#include <vug/field/deferred.h>
#include <vug/field/material_source.h>
#include <vug/field/registry.h>
#include <vug/field/speleothems/deposits.h>
#include <vug/field/thickened.h>
#include <vug/shot/drips_plan.h>

#include <fmt/format.h>

namespace vug::shot {

DripsPlan::DripsPlan(const DripParams& params) : rock_(params.field), options_(params.options()) {
  drips::require_valid(options_.graph.edits, options_.graph);
  drips::require_in_air(options_.graph.edits, rock_);
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

namespace {

/// Flowstone is this thick in metres where half of the material is its own.
constexpr double kThinnestFlowstone = 0.001;

field::Field made_of(const field::Field& solid, const field::RockMaterialPtr& material) {
  return field::make("made_of", {{"field", field::as_value(solid)},
                                 {"of", ValueTraits<field::RockMaterialPtr>::write(material)}});
}

/// The rock with its flowstone, whose material is that of the rock inside of the rock alone.
field::Field layered(const field::Field& rock, const field::Field& with_flowstone,
                     const field::RockMaterialPtr& material) {
  if (field::materials_of(rock).empty())
    throw Error(ErrorCode::bad_input,
                fmt::format("the speleothems are made of '{}', but the rock has no material",
                            material->name),
                {}, "give the rock one: made_of(rock, of: \"limestone\")");
  const field::Field core =
      field::make("offset", {{"field", field::as_value(rock)}, {"by", 0.5 * kThinnestFlowstone}});
  return field::make("host_rock", {{"field", field::as_value(with_flowstone)},
                                   {"of", ValueTraits<field::RockMaterialPtr>::write(material)},
                                   {"bodies", List{field::as_value(core)}},
                                   {"contact", kThinnestFlowstone}});
}

}  // namespace

field::Field with_speleothems(const DripsPtr& drips, const SpeleothemJoin& join,
                              SpeleothemPart part) {
  const drips::DripstoneOptions& options = drips->options();
  const Box3d bounds =
      drips::dripstone_bounds(drips->rock().bounds(), options.graph, options.forms);
  const double bytes = drips::graph_memory(options.graph);
  const field::Field solids = field::deferred(
      {drips::kDripstoneSlope, field::Exactness::sign, bounds, drips::kDripstoneGrowth},
      "finding drips", [drips] { return drips->grown().solids; }, bytes);
  const field::Field own = join.material ? made_of(solids, join.material) : solids;
  if (part == SpeleothemPart::solids) return own;
  const field::Field thickness = field::deferred(
      {field::kSteepestDeposit, field::Exactness::sign, infinite_box(), 0}, "laying flowstone",
      [drips] { return drips->grown().thickness; }, bytes);
  const field::Field thick = field::thickened(drips->rock(), thickness, field::kThickestDeposit),
                     rock = join.material ? layered(drips->rock(), thick, join.material) : thick;
  if (part == SpeleothemPart::rock) return rock;
  return field::unite({rock, own}, field::Blend{field::Profile::smooth, join.root});
}

}  // namespace vug::shot
