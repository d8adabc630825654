// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/drips/basin.h>
#include <vug/drips/film_network.h>
#include <vug/drips/pools.h>

#include <algorithm>
#include <cmath>

namespace vug::drips {
namespace {

/// A pool is searched once for all lows that are nearer to each other than this, in metres.
constexpr double kSamePool = 0.15;

class Pools {
 public:
  Pools(Graph& graph, const field::Field& rock, const FilmOptions& films, double spacing)
      : graph_(graph), rock_(rock), films_(films), spacing_(spacing) {}

  void fill(const std::vector<int>& lows) {
    std::vector<std::optional<Basin>> basins(lows.size());
    parallel_for(lows.size(),
                 [&](size_t i) { basins[i] = basin_at(rock_, at(lows[i]), options()); });
    for (size_t i = 0; i < lows.size(); ++i)
      if (basins[i]) add(lows[i], *basins[i]);
    // From the highest on, so that all that a pool receives is known when it runs over.
    while (!waiting_.empty()) {
      const auto highest = std::max_element(waiting_.begin(), waiting_.end(),
                                            [&](int a, int b) { return level(a) < level(b); });
      const int pool = *highest;
      waiting_.erase(highest);
      run_over(pool);
    }
  }

 private:
  struct Pool {
    int node;
    Basin basin;
  };
  Vec3d at(int node) const { return graph_.nodes[static_cast<size_t>(node)].position; }
  double level(int pool) const { return pools_[static_cast<size_t>(pool)].basin.level; }
  BasinOptions options() const { return {.region = films_.region}; }

  /// Makes the node a pool, or a way into the pool that is there.
  void add(int low, const Basin& basin) {
    Node& node = graph_.nodes[static_cast<size_t>(low)];
    node.kind = NodeKind::pool;
    node.level = basin.level;
    const Box3d& region = films_.region;
    const double across = std::ceil((region.max.x - region.min.x) / spacing_);
    node.id =
        static_cast<int64_t>(std::floor((node.position.x - region.min.x) / spacing_) +
                             across * std::floor((node.position.z - region.min.z) / spacing_));
    for (const Pool& other : pools_)
      if ((at(other.node) - node.position).length() < kSamePool ||
          (std::fabs(other.basin.level - basin.level) < 1e-3 &&
           (other.basin.spill - basin.spill).length() < kSamePool))
        return join(low, other);
    waiting_.push_back(static_cast<int>(pools_.size()));
    pools_.push_back({low, basin});
  }
  void join(int low, const Pool& pool) {
    Node& from = graph_.nodes[static_cast<size_t>(low)];
    Node& to = graph_.nodes[static_cast<size_t>(pool.node)];
    from.level = std::max(to.level, from.position.y);
    graph_.edges.push_back(
        {EdgeKind::overflow, low, pool.node, {from.position, to.position}, from.water});
    to.water = mixed(to.water, from.water);
  }

  void run_over(int pool) {
    const Pool from = pools_[static_cast<size_t>(pool)];
    const Film film = floor_film(rock_, from.basin.spill, films_);
    int end = -1;
    for (size_t i = 0; i < pools_.size() && end < 0; ++i)
      if ((at(pools_[i].node) - film.path.back()).length() < kSamePool) end = static_cast<int>(i);
    std::optional<Basin> below;
    if (end < 0 && film.end == FilmEnd::low) below = basin_at(rock_, film.path.back(), options());
    // Water that would come back stays: both are parts of a larger basin.
    const double reached = end >= 0 ? level(end) : below ? below->level : -kInfinity;
    if (!(reached < from.basin.level - 1e-3)) return;
    int node = end >= 0 ? pools_[static_cast<size_t>(end)].node : -1;
    if (node < 0) {
      node = static_cast<int>(graph_.nodes.size());
      Node sink;
      sink.kind = NodeKind::sink;
      sink.id = graph_.nodes[static_cast<size_t>(from.node)].id;
      sink.position = film.path.back();
      sink.normal = film.normal;
      graph_.nodes.push_back(sink);
    }
    Edge edge{EdgeKind::overflow, from.node, node, {at(from.node)}, {}};
    edge.path.insert(edge.path.end(), film.path.begin(), film.path.end());
    edge.water = graph_.nodes[static_cast<size_t>(from.node)].water;
    const Water arrived = after_film(edge.water, film.path, film_width(edge.kind));
    Node& there = graph_.nodes[static_cast<size_t>(node)];
    there.water = mixed(there.water, arrived);
    graph_.edges.push_back(std::move(edge));
    if (end < 0 && below) add(node, *below);
  }

  Graph& graph_;
  const field::Field& rock_;
  const FilmOptions& films_;
  double spacing_;
  std::vector<Pool> pools_;
  std::vector<int> waiting_;  ///< Indices of pools whose overflow has not been followed.
};

}  // namespace

void fill_pools(Graph& graph, const field::Field& rock, const std::vector<int>& lows,
                const FilmOptions& films, double spacing) {
  Pools(graph, rock, films, spacing).fill(lows);
}

}  // namespace vug::drips
