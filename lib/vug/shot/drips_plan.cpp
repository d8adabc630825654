// SPDX-License-Identifier: Apache-2.0
#include <vug/shot/drips_plan.h>

namespace vug::shot {

const drips::Graph& DripsPlan::graph() const {
  const std::lock_guard lock(computing_);
  if (!graph_)
    graph_ =
        std::make_unique<const drips::Graph>(drips::build_graph(params_.field, params_.graph()));
  return *graph_;
}

}  // namespace vug::shot
