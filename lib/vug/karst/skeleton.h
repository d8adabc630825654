// SPDX-License-Identifier: Apache-2.0
// Ways between key points that do not follow the flow to springs.
#pragma once

#include <vug/karst/flow.h>

namespace vug::karst {

/// Joins the points by the gamma graph of their distances d, the costs of the cheapest ways: the
/// way between i and j is built unless d(i,k)^gamma + d(k,j)^gamma < d(i,j)^gamma for a third point
/// k (paris2021karst, section 5). The points become one connected part.
void add_skeleton(const FlowCost& cost, const std::vector<int>& points, double gamma, Plan& plan);

/// Joins each point to the network by its cheapest way; the first one starts it if it is empty.
void connect(const FlowCost& cost, const std::vector<int>& points, Plan& plan);

}  // namespace vug::karst
