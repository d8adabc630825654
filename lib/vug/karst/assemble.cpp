// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <vug/base/error.h>
#include <vug/karst/assemble.h>
#include <vug/karst/separation.h>
#include <vug/karst/shape_legs.h>
#include <vug/network/reduction.h>

#include <set>

namespace vug::karst {
namespace {

constexpr double kShortestTip = 0.1;  ///< Remaining fraction of the leg to a blind end.

/// Blind ends are anywhere between two samples, so the last leg loses a random part.
void shorten_tips(network::Network& network, const Plan& plan, const Samples& samples,
                  RandomKey key) {
  const std::vector<int> points = plan.points();
  for (const network::Leg& leg : network.legs)
    for (const auto& [end, inner] : {std::pair(leg.from, leg.to), std::pair(leg.to, leg.from)}) {
      const int point = points[static_cast<size_t>(end)];
      if (point < samples.random || plan.degree(point) != 1) continue;
      const double kept =
          RandomStream(key.at(static_cast<uint64_t>(point))).uniform(kShortestTip, 1);
      const Vec3d& from = network.stations[static_cast<size_t>(inner)].position;
      Vec3d& tip = network.stations[static_cast<size_t>(end)].position;
      tip = from + (tip - from) * kept;
    }
}

/// Replaces each leg by the legs of its shape.
void replace_legs(network::Network& network, const std::vector<std::vector<Vec3d>>& shapes) {
  const std::vector<network::Leg> coarse = std::move(network.legs);
  network.legs.clear();
  for (size_t i = 0; i < coarse.size(); ++i) {
    network::Leg leg = coarse[i];
    for (size_t p = 1; p < shapes[i].size(); ++p) {
      const bool last = p + 1 == shapes[i].size();
      leg.to = last ? coarse[i].to : static_cast<int>(network.stations.size());
      if (!last) network.stations.push_back({.position = shapes[i][p]});
      network.legs.push_back(leg);
      leg.from = leg.to;
    }
  }
}

void flag_key_points(network::Network& network, const Plan& plan, const KeyPoints& keys,
                     const Samples& samples) {
  const std::vector<int> points = plan.points();
  std::set<std::string> names;
  for (size_t i = 0; i < points.size() && points[i] < samples.random; ++i) {
    network::Station& station = network.stations[i];
    const int point = points[i];
    if (point < samples.springs) {
      station.flags.sink = true;
      station.name = keys.sinks[static_cast<size_t>(point)].name;
    } else if (point < samples.entrances) {
      station.flags.spring = true;
      station.name = keys.springs[static_cast<size_t>(point - samples.springs)].name;
    } else if (point < samples.waypoints) {
      station.flags.entrance = true;
      station.name = fmt::format("entrance.{}", point - samples.entrances + 1);
    } else {
      station.name = fmt::format("waypoint.{}", point - samples.waypoints + 1);
    }
    if (!names.insert(station.name).second || station.name.starts_with("passage."))
      throw Error(ErrorCode::bad_input,
                  fmt::format("the name '{}' of a key point cannot be used", station.name), {},
                  "names of sinks and springs must differ and must not start with 'passage.'");
  }
}

/// Numbers the passages from junction to junction, and the stations along them.
void name_passages(network::Network& network) {
  const auto legs_at = network::legs_at_stations(network);
  const network::Reduction reduction = network::reduce(network);
  for (size_t b = 0; b < reduction.branches.size(); ++b) {
    const std::string passage = fmt::format("passage.{}", b + 1);
    const std::vector<int>& stations = reduction.branches[b].stations;
    int number = 0;
    for (size_t i = 0; i < stations.size(); ++i) {
      network::Station& station = network.stations[static_cast<size_t>(stations[i])];
      if (station.name.empty()) station.name = fmt::format("{}.{}", passage, ++number);
      if (i == 0) continue;
      for (const int index : legs_at[static_cast<size_t>(stations[i])]) {
        network::Leg& leg = network.legs[static_cast<size_t>(index)];
        if (leg.from == stations[i - 1] || leg.to == stations[i - 1]) leg.survey = passage;
      }
    }
  }
}

}  // namespace

network::Network assemble(const Plan& plan, const KeyPoints& keys, const Samples& samples,
                          const Rock& rock, const KarstOptions& options) {
  network::Network network = plan.network();
  flag_key_points(network, plan, keys, samples);
  shorten_tips(network, plan, samples, RandomKey(options.seed).at("tips"));
  const std::vector<int> places = stations_of_points(plan.graph().points, samples.random,
                                                     kMeeting * options.samples.separation);
  std::vector<int> place_of_station;
  for (const int point : plan.points())
    place_of_station.push_back(places[static_cast<size_t>(point)]);
  replace_legs(network, shape_legs(network, place_of_station, rock, options));
  name_passages(network);
  return network;
}

}  // namespace vug::karst
