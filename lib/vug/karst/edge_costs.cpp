// SPDX-License-Identifier: Apache-2.0
// The cost of legs by the rock around them.
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/karst/rock.h>
#include <vug/karst/sample_graph.h>

#include <algorithm>

namespace vug::karst {
namespace {

constexpr size_t kGrain = 256;
constexpr double kThroughAir = 1000;  ///< Factor of the cost of a leg that leaves the rock.
constexpr double kShortest = 1e-3;    ///< Metres; so that no cost is 0.

/// 1 + the weights of the rock in the middle of a leg, which follows joints and faults by 0 to 1.
double rock_factor(const Vec3d& middle, double alignment, const Rock& rock, const CostOptions& o) {
  const Geology& g = rock.geology();
  double factor = 1;
  if (!g.beds.empty())
    factor += o.bed * (1 - smooth_falloff(rock.bed_distance(middle), o.bed_reach));
  if (!rock.joints().empty() || !g.faults.empty()) factor += o.fracture * (1 - alignment);
  if (rock.has_permeability()) factor += o.permeability * (1 - rock.permeability(middle));
  if (!g.ghost_rock.empty() && !rock.in_ghost_rock(middle)) factor += o.ghost_rock;
  return factor;
}

}  // namespace

std::vector<double> edge_costs(const SampleGraph& graph, const Rock& rock,
                               const KarstOptions& options,
                               const std::vector<std::array<int, 2>>& joint_edges) {
  const CostOptions& o = options.cost;
  const RandomKey key = RandomKey(options.seed).at("heterogeneity");
  double total = 0;
  for (size_t e = 0; e < graph.edges.size(); ++e) total += graph.length(static_cast<int>(e));
  const double mean_length =
      std::max(kShortest, total / static_cast<double>(std::max<size_t>(1, graph.edges.size())));
  std::vector<double> costs(graph.edges.size());
  parallel_for(
      costs.size(),
      [&](size_t e) {
        const auto& [a, b] = graph.edges[e];
        const Vec3d& from = graph.points[static_cast<size_t>(a)];
        const Vec3d& to = graph.points[static_cast<size_t>(b)];
        const double length = std::max(kShortest, (to - from).length());
        const Vec3d middle = (from + to) * 0.5, direction = (to - from) / length;
        const double along_joint =
            joint_edges.empty() ? rock.joint_alignment(middle, direction)
            : std::binary_search(joint_edges.begin(), joint_edges.end(), graph.edges[e]) ? 1.0
                                                                                         : 0.0;
        const double alignment = std::max(along_joint, rock.fault_alignment(middle, direction));
        double cost = length * maths::pow(length / mean_length, o.shortness) *
                      rock_factor(middle, alignment, rock, o);
        if (o.heterogeneity > 0)
          cost *= maths::exp(o.heterogeneity * RandomStream(key.at(e)).normal());
        if (rock.geology().solid && !rock.contains(middle)) cost *= kThroughAir;
        costs[e] = cost;
      },
      kGrain);
  return costs;
}

}  // namespace vug::karst
