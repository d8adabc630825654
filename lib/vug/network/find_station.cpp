// SPDX-License-Identifier: Apache-2.0
#include <vug/base/diagnostics.h>
#include <vug/base/error.h>
#include <vug/network/find_station.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace vug::network {
namespace {

/// Whether `full` consists of levels before `name` and `name`.
bool ends_in_levels(std::string_view full, std::string_view name) {
  return full.size() > name.size() && full.ends_with(name) &&
         full[full.size() - name.size() - 1] == '.';
}

[[noreturn]] void refuse_unknown(const Network& network, const std::string& name) {
  std::vector<std::string> known;
  for (const Station& station : network.stations) {
    if (station.name.empty()) continue;
    known.push_back(station.name);
    const size_t dot = station.name.rfind('.');
    if (dot != std::string::npos) known.push_back(station.name.substr(dot + 1));
  }
  throw Error(ErrorCode::bad_input, fmt::format("the network has no station '{}'", name), {},
              did_you_mean(name, known, "vug survey --stations lists the stations of a survey"));
}

/// Whether the stations are at one place, as equated ones are.
bool coincide(const Network& network, const std::vector<int>& stations) {
  const auto position = [&](int i) { return network.stations[static_cast<size_t>(i)].position; };
  return std::all_of(stations.begin(), stations.end(),
                     [&](int i) { return position(i) == position(stations.front()); });
}

}  // namespace

int find_station(const Network& network, std::string_view name) {
  if (name.empty()) refuse_unknown(network, "");
  std::vector<int> found;
  for (size_t i = 0; i < network.stations.size(); ++i) {
    if (network.stations[i].name == name) return static_cast<int>(i);
    if (ends_in_levels(network.stations[i].name, name)) found.push_back(static_cast<int>(i));
  }
  if (found.empty()) refuse_unknown(network, std::string(name));
  if (!coincide(network, found)) {
    std::vector<std::string> candidates;
    for (size_t i = 0; i < std::min<size_t>(found.size(), 5); ++i)
      candidates.push_back(network.stations[static_cast<size_t>(found[i])].name);
    throw Error(ErrorCode::bad_input, fmt::format("{} stations end in '{}'", found.size(), name),
                {},
                fmt::format("write more of its name: {}{}", fmt::join(candidates, ", "),
                            found.size() > candidates.size() ? ", ..." : ""));
  }
  return found.front();
}

}  // namespace vug::network
