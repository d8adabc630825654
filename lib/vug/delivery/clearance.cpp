// SPDX-License-Identifier: Apache-2.0
#include <vug/base/memory.h>
#include <vug/delivery/clearance.h>
#include <vug/network/farthest.h>
#include <vug/network/find_station.h>
#include <vug/shot/queries.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace vug::delivery {
namespace {

constexpr double kTolerance = 0.02;  // Of the widest body, metres.
constexpr size_t kMostNamed = 8;     // Stations in a table.

class Passage {
 public:
  Passage(building::Builder& builder, const volume::LevelSet& rock, const network::Network& plan)
      : builder_(builder), rock_(rock) {
    for (const network::Station& station : plan.stations) points_.push_back(station.position);
  }
  std::vector<int> regions(const volume::UprightCapsule& body) const {
    volume::ClearanceOptions options;
    options.body = body;
    const uint64_t most = builder_.options().max_memory;
    options.max_memory = most > 0 ? most : available_memory();
    return volume::free_regions(rock_, points_, options, builder_.progress());
  }
  bool passes(double diameter, double height, int from, int to) const {
    const std::vector<int> found = regions({diameter, std::max(height, diameter)});
    return joined(found, from, to);
  }
  static bool joined(const std::vector<int>& regions, int from, int to) {
    const int region = regions[static_cast<size_t>(from)];
    return region >= 0 && region == regions[static_cast<size_t>(to)];
  }

 private:
  building::Builder& builder_;
  const volume::LevelSet& rock_;
  std::vector<Vec3d> points_;
};

double widest_body(const Passage& passage, const volume::UprightCapsule& body, int from, int to) {
  double passes = body.diameter, stuck = kWidestBody;
  if (passes >= stuck || passage.passes(stuck, body.height, from, to)) return stuck;
  while (stuck - passes > kTolerance) {
    const double middle = 0.5 * (passes + stuck);
    (passage.passes(middle, body.height, from, to) ? passes : stuck) = middle;
  }
  return passes;
}

}  // namespace

ClearanceReport measure_clearance(building::Builder& builder, const ClearanceRequest& request) {
  const shot::MeshPtr mesh = shot::find_mesh(builder.shot(), request.mesh);
  if (!mesh->volume)
    throw Error(ErrorCode::bad_input, fmt::format("the mesh '{}' has no volume", mesh->name), {},
                "--mesh selects one that is made from a volume");
  const shot::NetworkPlan& plan = shot::find_network(builder.shot(), request.network);
  const network::Network& cave = *plan.network;
  if (cave.stations.empty())
    throw Error(ErrorCode::bad_input, fmt::format("the network '{}' has no stations", plan.name));
  const int from = request.from.empty() ? network::first_station(cave)
                                        : network::find_station(cave, request.from);
  const int to = request.to.empty() ? network::farthest_station(cave, from)
                                    : network::find_station(cave, request.to);
  const auto name = [&](int station) { return cave.stations[static_cast<size_t>(station)].name; };
  const Passage passage(builder, builder.level_set(mesh->volume), cave);
  const std::vector<int> regions = passage.regions(request.body);
  ClearanceReport out;
  out.body = request.body;
  out.from = name(from);
  out.to = name(to);
  out.passes = Passage::joined(regions, from, to);
  if (out.passes) out.widest = widest_body(passage, request.body, from, to);
  for (int i = 0; i < static_cast<int>(cave.stations.size()); ++i) {
    if (cave.stations[static_cast<size_t>(i)].flags.surface) continue;
    ++out.stations;
    if (!Passage::joined(regions, from, i)) out.missing.push_back(name(i));
  }
  return out;
}

std::string to_table(const ClearanceReport& report) {
  const auto named = std::min(kMostNamed, report.missing.size());
  const std::vector<std::string> first(report.missing.begin(),
                                       report.missing.begin() + static_cast<std::ptrdiff_t>(named));
  std::string missing = fmt::format("{}", fmt::join(first, ", "));
  if (named < report.missing.size())
    missing += fmt::format(" and {} others", report.missing.size() - named);
  std::string table;
  const auto row = [&](const char* key, const std::string& value) {
    table += fmt::format("{:<18}  {}\n", key, value);
  };
  row("body", fmt::format("{:g} x {:g} m", report.body.diameter, report.body.height));
  row("from", report.from);
  row("to", report.to);
  row("passes", report.passes ? "yes" : "no");
  row("widest", !report.passes                 ? "-"
                : report.widest >= kWidestBody ? fmt::format("more than {:g} m", kWidestBody)
                                               : fmt::format("{:.2f} m", report.widest));
  row("stations reached",
      fmt::format("{} of {}", report.stations - static_cast<int>(report.missing.size()),
                  report.stations));
  if (!missing.empty()) row("not reached", missing);
  return table;
}

nlohmann::ordered_json to_json(const ClearanceReport& report) {
  return {{"body", {report.body.diameter, report.body.height}},
          {"from", report.from},
          {"to", report.to},
          {"passes", report.passes},
          {"widest", report.widest},
          {"stations", report.stations},
          {"not_reached", report.missing}};
}

}  // namespace vug::delivery
