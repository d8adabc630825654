// SPDX-License-Identifier: Apache-2.0
#include <vug/base/diagnostics.h>
#include <vug/base/error.h>
#include <vug/network/find_station.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

namespace vug::network {
namespace {

/// Whether `full` consists of levels before `name` and `name`.
bool ends_in_levels(std::string_view full, std::string_view name) {
  return full.size() > name.size() && full.ends_with(name) &&
         full[full.size() - name.size() - 1] == '.';
}

/// Calls visit(name) for all names of a station; not at all if it has no name.
template <class Visit>
void for_each_name(const Station& station, const Visit& visit) {
  if (!station.name.empty()) visit(station.name);
  for (const std::string& name : station.equated) visit(name);
}

/// For example "among its 321 stations are a, b, c, d, e".
std::string first_stations(const Network& network) {
  constexpr size_t kShown = 5;
  std::vector<std::string> first;
  for (const Station& station : network.stations)
    if (!station.name.empty() && first.size() < kShown) first.push_back(station.name);
  if (first.empty()) return "its stations have no names";
  return fmt::format("among its {} stations are {}", network.stations.size(),
                     fmt::join(first, ", "));
}

[[noreturn]] void refuse_unknown(const Network& network, const std::string& name) {
  std::vector<std::string> known;
  for (const Station& station : network.stations)
    for_each_name(station, [&](const std::string& full) {
      known.push_back(full);
      for (size_t dot = full.find('.'); dot != std::string::npos; dot = full.find('.', dot + 1))
        known.push_back(full.substr(dot + 1));
    });
  throw Error(ErrorCode::bad_input, fmt::format("the network has no station '{}'", name), {},
              did_you_mean(name, known, first_stations(network)));
}

}  // namespace

int find_station(const Network& network, std::string_view name) {
  if (name.empty()) refuse_unknown(network, "");
  std::vector<int> found;
  std::vector<std::string> candidates;
  std::optional<int> exact;
  for (size_t i = 0; i < network.stations.size() && !exact; ++i)
    for_each_name(network.stations[i], [&](const std::string& full) {
      const int station = static_cast<int>(i);
      if (full == name) exact = station;
      if (!ends_in_levels(full, name)) return;
      candidates.push_back(full);
      if (found.empty() || found.back() != station) found.push_back(station);
    });
  if (exact) return *exact;
  if (found.empty()) refuse_unknown(network, std::string(name));
  if (found.size() == 1) return found.front();
  constexpr size_t kShown = 5;
  const bool more = candidates.size() > kShown;
  candidates.resize(std::min(candidates.size(), kShown));
  throw Error(ErrorCode::bad_input, fmt::format("{} stations end in '{}'", found.size(), name), {},
              fmt::format("write more of its name: {}{}", fmt::join(candidates, ", "),
                          more ? ", ..." : ""));
}

}  // namespace vug::network
