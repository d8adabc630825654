// SPDX-License-Identifier: Apache-2.0
#include <vug/passages/curves/chains.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace vug::passages {
namespace {

using network::Network;

/// The first station at the position of each.
std::vector<int> first_at_position(const Network& network) {
  std::map<std::tuple<double, double, double>, int> first;
  std::vector<int> out;
  for (size_t i = 0; i < network.stations.size(); ++i) {
    const Vec3d& p = network.stations[i].position;
    const auto key = std::make_tuple(p.x + 0.0, p.y + 0.0, p.z + 0.0);
    out.push_back(first.emplace(key, static_cast<int>(i)).first->second);
  }
  return out;
}

class Tracer {
 public:
  explicit Tracer(const Network& network)
      : network_(network), first_(first_at_position(network)), legs_at_(network.stations.size()) {
    std::set<std::pair<int, int>> known;
    for (size_t i = 0; i < network.legs.size(); ++i) {
      const int a = station_of(i, false), b = station_of(i, true);
      const network::Leg& leg = network.legs[i];
      if (a == b || leg.surface || leg.duplicate || !known.insert(std::minmax(a, b)).second) {
        used_.push_back(true);
        continue;
      }
      used_.push_back(false);
      legs_at_[static_cast<size_t>(a)].push_back(static_cast<int>(i));
      legs_at_[static_cast<size_t>(b)].push_back(static_cast<int>(i));
    }
    for (size_t station = 0; station < legs_at_.size(); ++station)
      pair_up(static_cast<int>(station));
  }

  std::vector<Chain> trace() {
    std::vector<Chain> out;
    for (size_t i = 0; i < network_.legs.size(); ++i)
      if (!used_[i]) out.push_back(chain_of(static_cast<int>(i)));
    return out;
  }

 private:
  int station_of(size_t leg, bool to) const {
    const network::Leg& l = network_.legs[leg];
    return first_[static_cast<size_t>(to ? l.to : l.from)];
  }
  int other_end(int leg, int station) const {
    const auto i = static_cast<size_t>(leg);
    return station_of(i, false) == station ? station_of(i, true) : station_of(i, false);
  }
  Vec3d direction(int leg, int station) const {
    const auto at = [&](int s) { return network_.stations[static_cast<size_t>(s)].position; };
    return (at(other_end(leg, station)) - at(station)).normalized();
  }

  /// The two legs at a station whose directions are most opposite continue each other.
  void pair_up(int station) {
    const std::vector<int>& legs = legs_at_[static_cast<size_t>(station)];
    double best = kInfinity;
    std::pair<int, int> pair{-1, -1};
    for (size_t i = 0; i < legs.size(); ++i)
      for (size_t k = i + 1; k < legs.size(); ++k) {
        const double dot = direction(legs[i], station).dot(direction(legs[k], station));
        if (dot < best - 1e-12) {
          best = dot;
          pair = {legs[i], legs[k]};
        }
      }
    if (pair.first >= 0) pairs_[station] = pair;
  }
  int continuation(int leg, int station) const {
    const auto at = pairs_.find(station);
    if (at == pairs_.end()) return -1;
    const auto [a, b] = at->second;
    return leg == a ? b : leg == b ? a : -1;
  }

  Chain chain_of(int leg) {
    // Back to the first leg of the passage, or once around a ring.
    int first = leg, start = station_of(static_cast<size_t>(leg), false);
    for (;;) {
      const int before = continuation(first, start);
      if (before < 0 || before == leg) break;
      first = before;
      start = other_end(before, start);
    }
    Chain chain;
    chain.stations.push_back(start);
    int next = first, at = start;
    while (next >= 0 && !used_[static_cast<size_t>(next)]) {
      used_[static_cast<size_t>(next)] = true;
      chain.legs.push_back(next);
      at = other_end(next, at);
      chain.stations.push_back(at);
      next = continuation(next, at);
    }
    const bool ring =
        chain.stations.front() == chain.stations.back() && continuation(first, start) >= 0;
    chain.start_meets = !ring && legs_at_[static_cast<size_t>(start)].size() > 1;
    chain.end_meets = !ring && legs_at_[static_cast<size_t>(at)].size() > 1;
    orient(chain);
    return chain;
  }

  /// In the direction of most of its legs.
  void orient(Chain& chain) const {
    int along = 0;
    for (size_t i = 0; i < chain.legs.size(); ++i)
      along += station_of(static_cast<size_t>(chain.legs[i]), false) == chain.stations[i] ? 1 : -1;
    if (along >= 0) return;
    std::reverse(chain.legs.begin(), chain.legs.end());
    std::reverse(chain.stations.begin(), chain.stations.end());
    std::swap(chain.start_meets, chain.end_meets);
  }

  const Network& network_;
  std::vector<int> first_;
  std::vector<std::vector<int>> legs_at_;
  std::vector<bool> used_;
  std::map<int, std::pair<int, int>> pairs_;
};

}  // namespace

std::vector<Chain> chains(const Network& network) { return Tracer(network).trace(); }

}  // namespace vug::passages
