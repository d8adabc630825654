// SPDX-License-Identifier: Apache-2.0
// The draperies that grow along the films under sloping roofs.
#pragma once

#include <vug/drips/graph.h>
#include <vug/field/field.h>
#include <vug/field/speleothems/drapery_sheet.h>

namespace vug::drips {

struct DraperyOptions {
  double share = 0.5;    ///< The share of the suitable films below which draperies hang, 0..1.
  double fold = 0.12;    ///< Mean distance of their folds in metres.
  double tip = 0.00255;  ///< Least half of their thickness in metres.
  double floor = -5;     ///< Height above which the rock below them is searched.
  uint64_t seed = 1;
};

struct HungDrapery {
  int64_t drip = 0;  ///< The id of the seep of its film.
  field::Drapery sheet{};
};

/// Water under a nearly level roof makes stalactites, under one of 30 to 60 degrees draperies, and
/// on a wall flowstone. Draperies grow as far down as the water of their age and rate permits, and
/// not more than half of the way to the floor. In the order of their drips.
std::vector<HungDrapery> draperies_of(const field::Field& rock, const Graph& graph,
                                      const DraperyOptions& options);

/// The share of the films with a mean slope in radians that grow draperies: 0 to 1.
double drapery_share(double slope);

/// Their solids.
std::vector<field::Field> drapery_fields(const std::vector<HungDrapery>& draperies,
                                         const DraperyOptions& options);

}  // namespace vug::drips
