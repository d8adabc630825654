// SPDX-License-Identifier: Apache-2.0
#include <vug/survey/report.h>

#include <vug/survey/statistics.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace vug::survey {
namespace {

using Json = nlohmann::ordered_json;

/// Rounded to a number of decimals, so that reports are readable.
double rounded(double value, int decimals = 2) {
  const double scale = decimals == 2 ? 100 : 1000;
  return std::round(value * scale) / scale + 0.0;
}

std::string name_of(const Survey& survey, int station) {
  const Station& each = survey.stations[static_cast<size_t>(station)];
  return each.anonymous() ? "(anonymous)" : each.name;
}

Json extent_json(const Survey& survey, const Extent& extent) {
  if (extent.low_station < 0) return nullptr;
  return {{"range", rounded(extent.size())},
          {"low", rounded(extent.low)},
          {"low_station", name_of(survey, extent.low_station)},
          {"high", rounded(extent.high)},
          {"high_station", name_of(survey, extent.high_station)}};
}

/// The middle of the stations, rounded to metres, as networks of scenes use it by default.
Json origin_json(const Statistics& size) {
  if (size.east.low_station < 0) return nullptr;
  Json out = Json::array();
  for (const Extent* axis : {&size.east, &size.north, &size.altitude})
    out.push_back(std::llround(0.5 * axis->low + 0.5 * axis->high));
  return out;
}

Json misclosure_json(const Survey& survey, const Misclosure& each) {
  Json out;
  if (!each.stations.empty()) {
    out["from"] = name_of(survey, each.stations.front());
    out["to"] = name_of(survey, each.stations.back());
  }
  out["legs"] = each.legs;
  out["length"] = rounded(each.length);
  out["error"] = {rounded(each.error.x, 3), rounded(each.error.y, 3), rounded(each.error.z, 3)};
  out["e"] = rounded(each.e);
  out["h"] = rounded(each.h);
  out["v"] = rounded(each.v);
  return out;
}

Json blunder_json(const Survey& survey, const Blunder& each) {
  const Leg& leg = survey.legs[static_cast<size_t>(each.leg)];
  const bool angle = each.reading == "compass" || each.reading == "clino";
  Json out = {{"from", name_of(survey, leg.from)},
              {"to", name_of(survey, leg.to)},
              {"reading", each.reading},
              {"error", rounded(angle ? each.error * 180 / kPi : each.error)},
              {"unit", angle ? "degrees" : "metres"},
              {"sigmas", rounded(each.sigmas)}};
  if (leg.where.known()) out["place"] = to_string(leg.where);
  return out;
}

}  // namespace

Json report(const Survey& survey) {
  const Statistics size = measure(survey);
  Json out;
  if (!survey.title.empty()) out["title"] = survey.title;
  out["coordinate_system"] = survey.coordinate_system.empty() ? "local" : survey.coordinate_system;
  out["stations"] = size.stations;
  out["legs"] = size.legs;
  out["equates"] = size.equates;
  out["splays"] = size.splays;
  out["components"] = size.components;
  out["loops"] = size.loops;
  if (size.survex_loops)
    out["as_survex_counts"] = {{"components", *size.survex_components},
                               {"loops", *size.survex_loops}};
  out["cross_sections"] = size.cross_sections;
  out["length"] = {
      {"measured", rounded(size.length)},        {"adjusted", rounded(size.adjusted_length)},
      {"plan", rounded(size.plan_length)},       {"vertical", rounded(size.vertical_length)},
      {"surface", rounded(size.surface_length)}, {"duplicate", rounded(size.duplicate_length)}};
  out["altitude"] = extent_json(survey, size.altitude);
  out["north"] = extent_json(survey, size.north);
  out["east"] = extent_json(survey, size.east);
  out["origin"] = origin_json(size);
  out["degrees"] = Json::object();
  for (const auto& [degree, count] : size.degrees) out["degrees"][std::to_string(degree)] = count;
  out["misclosures"] = Json::array();
  // Those of a file have any order.
  std::vector<Misclosure> misclosures = survey.misclosures;
  std::stable_sort(misclosures.begin(), misclosures.end(),
                   [](const Misclosure& a, const Misclosure& b) { return a.e > b.e; });
  for (const Misclosure& each : misclosures)
    out["misclosures"].push_back(misclosure_json(survey, each));
  out["blunders"] = Json::array();
  for (const Blunder& each : survey.blunders) out["blunders"].push_back(blunder_json(survey, each));
  return out;
}

Json station_list(const Survey& survey) {
  Json out = Json::array();
  for (const Station& station : survey.stations) {
    if (station.anonymous()) continue;
    Json flags = Json::array();
    for (const auto& [flag, set] : {std::pair("entrance", station.entrance),
                                    {"fixed", station.fixed},
                                    {"exported", station.exported},
                                    {"surface", station.surface}})
      if (set) flags.push_back(flag);
    out.push_back({{"name", station.name},
                   {"east", rounded(station.position.x)},
                   {"north", rounded(station.position.y)},
                   {"up", rounded(station.position.z)},
                   {"flags", std::move(flags)}});
  }
  return out;
}

}  // namespace vug::survey
