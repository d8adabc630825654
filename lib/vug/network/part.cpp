// SPDX-License-Identifier: Apache-2.0
#include <vug/base/diagnostics.h>
#include <vug/base/error.h>
#include <vug/network/part.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace vug::network {
namespace {

/// Whether the levels of `part` are consecutive levels of `full`.
bool has_levels(std::string_view full, std::string_view part) {
  for (size_t at = full.find(part); at != full.npos; at = full.find(part, at + 1)) {
    const size_t end = at + part.size();
    if ((at == 0 || full[at - 1] == '.') && (end == full.size() || full[end] == '.')) return true;
  }
  return false;
}

/// All levels of the names that is_in_survey reads.
std::vector<std::string> known_levels(const Network& network) {
  std::set<std::string> levels;
  const auto add = [&](const std::string& name) {
    for (size_t at = 0; at < name.size();) {
      const size_t dot = std::min(name.find('.', at), name.size());
      levels.insert(name.substr(at, dot - at));
      at = dot + 1;
    }
  };
  for (const Leg& leg : network.legs) {
    add(leg.survey);
    if (!leg.survey.empty()) continue;
    for (const int end : {leg.from, leg.to}) add(network.stations[static_cast<size_t>(end)].name);
  }
  return {levels.begin(), levels.end()};
}

bool fulfils(const Network& network, const Leg& leg, const PartOptions& options) {
  return (options.name.empty() || is_in_survey(network, leg, options.name)) &&
         (!options.stage || leg.stage == *options.stage) &&
         (!options.tier || leg.tier == *options.tier);
}

}  // namespace

bool is_in_survey(const Network& network, const Leg& leg, std::string_view name) {
  if (!leg.survey.empty()) return has_levels(leg.survey, name);
  return has_levels(network.stations[static_cast<size_t>(leg.from)].name, name) &&
         has_levels(network.stations[static_cast<size_t>(leg.to)].name, name);
}

Network part_of(const Network& network, const PartOptions& options) {
  Network out = network;
  std::erase_if(out.legs,
                [&](const Leg& leg) { return fulfils(network, leg, options) == options.rest; });
  if (!out.legs.empty()) return out;
  if (options.rest)
    throw Error(ErrorCode::bad_input, "the rest of the network has no legs", {},
                "give conditions that some legs do not fulfil");
  if (!options.name.empty()) {
    bool named = false;
    for (const Leg& leg : network.legs) named = named || is_in_survey(network, leg, options.name);
    if (!named)
      throw Error(ErrorCode::bad_input,
                  fmt::format("no leg of the network belongs to a survey '{}'", options.name), {},
                  did_you_mean(options.name, known_levels(network),
                               "names are levels of surveys, or of stations of legs without one"));
  }
  throw Error(ErrorCode::bad_input, "no leg of the network fulfils all conditions", {},
              "remove a condition, such as the stage or the tier");
}

}  // namespace vug::network
