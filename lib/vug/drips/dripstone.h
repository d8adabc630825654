// SPDX-License-Identifier: Apache-2.0
// All speleothems of a rock: from its drips to their solids.
#pragma once

#include <vug/drips/build_graph.h>
#include <vug/drips/draperies.h>
#include <vug/drips/form_fields.h>
#include <vug/drips/layers.h>

namespace vug::drips {

struct DripstoneOptions {
  GraphOptions graph{};
  FormOptions forms{};
  DraperyOptions draperies{};
  FlowstoneOptions flowstone{};
};

/// Speleothems as plain data, which can be stored.
struct GrownForms {
  std::vector<Form> forms{};  ///< Those of forms_of, then the pieces that broke off.
  std::vector<HungDrapery> draperies{};
  std::vector<field::Deposit> layers{};  ///< Skirts and flowstone.
};

struct Dripstone : GrownForms {
  field::Field solids;     ///< The solids of all forms and draperies.
  field::Field thickness;  ///< The thickness of the flowstone on the rock, see thickness_field.
};

/// Bounds of the slope of the solids, most of which is that of their lumps, and of their growth;
/// see field::Traits.
inline constexpr double kDripstoneSlope = 8, kDripstoneGrowth = 0.5;

/// The speleothems of a rock, whose air is where it is positive, from its drips. The result is the
/// same for any number of threads.
Dripstone grow_dripstone(const field::Field& rock, const Graph& graph,
                         const DripstoneOptions& options);

/// The steps of grow_dripstone: the growth, most of its work, which evaluates the rock, and the
/// fields of what has grown.
GrownForms grow_forms(const field::Field& rock, const Graph& graph,
                      const DripstoneOptions& options);
Dripstone with_fields(GrownForms grown, const DripstoneOptions& options);

/// Bounds of the speleothems of all drips that rock with these bounds can have.
Box3d dripstone_bounds(const Box3d& rock, const GraphOptions& graph, const FormOptions& forms);

}  // namespace vug::drips
