// SPDX-License-Identifier: Apache-2.0
// Internal to drips: the pools that a graph's floor films fill, and the ways of their overflow.
#pragma once

#include <vug/drips/film_path.h>
#include <vug/drips/graph.h>

namespace vug::drips {

/// Turns the lows among the nodes into pools with their level, and follows the water that runs over
/// to lower pools. Lows of one basin share the pool of the lowest of them. Ids of pools count
/// the columns of `spacing` metres in the films' region.
void fill_pools(Graph& graph, const field::Field& rock, const std::vector<int>& lows,
                const FilmOptions& films, double spacing);

}  // namespace vug::drips
