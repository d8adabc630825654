// SPDX-License-Identifier: Apache-2.0
#include <vug/terrain/exits.h>

#include <vug/base/disjoint_sets.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace vug::terrain {
namespace {

/// Metres between places on a leg, unless it is very long.
constexpr double kSpacing = 0.5;
constexpr int kMostPlaces = 2000;

/// Metres around an opening that may lie in the open.
constexpr double kOpening = 10;

struct Opening {
  Vec3d position;
  double radius;
};

std::vector<Opening> openings_of(const network::Network& network) {
  std::vector<Opening> openings;
  const auto add = [&](const network::Station& station) {
    const network::CrossSection s = station.section.value_or(network::CrossSection{});
    const double size =
        s.left.value_or(0) + s.right.value_or(0) + s.up.value_or(0) + s.down.value_or(0);
    openings.push_back({station.position, std::max(kOpening, size)});
  };
  for (const network::Station& station : network.stations) {
    const network::StationFlags& flags = station.flags;
    if (flags.entrance || flags.sink || flags.spring || flags.surface) add(station);
  }
  if (!openings.empty()) return openings;
  const std::vector<std::vector<int>> legs = network::legs_at_stations(network);
  for (size_t i = 0; i < legs.size(); ++i)
    if (legs[i].size() == 1) add(network.stations[i]);
  return openings;
}

class Search {
 public:
  Search(const network::Network& network, const field::Ground& ground)
      : network_(network), ground_(ground), openings_(openings_of(network)) {}

  /// The highest exit of a leg above a height; without one, its height is this one.
  Exit of(const network::Leg& leg, double tolerance) const {
    const network::Station &a = station(leg.from), &b = station(leg.to);
    const double length = (b.position - a.position).length();
    const int count = static_cast<int>(std::clamp(length / kSpacing, 1.0, kMostPlaces * 1.0));
    Exit worst{.position = a.position, .station = {}, .height = tolerance};
    for (int i = 0; i <= count; ++i) {
      const double t = static_cast<double>(i) / count;
      const Vec3d p = a.position + (b.position - a.position) * t;
      const double roof = p.y + up(a) * (1 - t) + up(b) * t;
      const double above = roof - ground_.height(p.x, p.z);
      if (above > worst.height && !is_opening(p)) worst = {p, t < 0.5 ? a.name : b.name, above};
    }
    return worst;
  }

 private:
  const network::Station& station(int i) const { return network_.stations[static_cast<size_t>(i)]; }
  static double up(const network::Station& station) {
    return station.section ? station.section->up.value_or(0) : 0;
  }
  bool is_opening(const Vec3d& p) const {
    return std::any_of(openings_.begin(), openings_.end(), [&](const Opening& one) {
      return (p - one.position).length() <= one.radius;
    });
  }

  const network::Network& network_;
  const field::Ground& ground_;
  std::vector<Opening> openings_;
};

}  // namespace

std::vector<Exit> exits(const network::Network& network, const field::Ground& ground,
                        double tolerance) {
  const Search search(network, ground);
  DisjointSets<int> parts(network.stations.size());
  std::vector<std::pair<int, Exit>> found;  // With a station of its leg.
  for (const network::Leg& leg : network.legs) {
    if (leg.surface) continue;
    Exit one = search.of(leg, tolerance);
    if (!(one.height > tolerance)) continue;
    parts.join(leg.from, leg.to);
    found.emplace_back(leg.from, std::move(one));
  }
  std::map<int, Exit> worst;
  for (auto& [station, one] : found) {
    const auto [known, is_new] = worst.try_emplace(parts.root(station), one);
    if (!is_new && one.height > known->second.height) known->second = one;
  }
  std::vector<Exit> out;
  for (auto& [root, one] : worst) out.push_back(std::move(one));
  std::stable_sort(out.begin(), out.end(),
                   [](const Exit& a, const Exit& b) { return a.height > b.height; });
  return out;
}

}  // namespace vug::terrain
