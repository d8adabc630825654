// SPDX-License-Identifier: Apache-2.0
// Internal to adjust: the number of connected components that Survex's cavern reports.
#pragma once

#include <vug/survey/observations.h>

#include <optional>

namespace vug::survey {

/// The components as cavern 1.4.4 counts them, from which it computes the number of loops. In its
/// network, a node has at most three legs, so that stations with more legs consist of several
/// nodes, and equates are legs. A component starts at each fixed node that the fixed nodes before
/// it do not reach through nodes that are not fixed or through one leg. Stations that are equated
/// to a fixed one, and all nodes of a fixed station, are fixed; therefore one connected survey can
/// have several components. Their number depends on the order of fixes, equates and legs.
/// No number if a part of the survey is not connected to a fixed station, which cavern refuses,
/// other than a survey without fixes, whose first station is fixed.
std::optional<int> survex_components(const Observations& observations);

}  // namespace vug::survey
