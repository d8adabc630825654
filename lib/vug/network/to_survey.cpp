// SPDX-License-Identifier: Apache-2.0
// The conversion of a network to a survey.
#include <vug/network/from_survey.h>
#include <vug/network/reduction.h>
#include <vug/network/survey_space.h>

#include <set>
#include <utility>

namespace vug::network {
namespace {

/// The names of the stations; those without one get the next free number.
std::vector<std::string> unique_names(const Network& network) {
  std::set<std::string> taken;
  for (const Station& station : network.stations) {
    taken.insert(station.name);
    taken.insert(station.equated.begin(), station.equated.end());
  }
  std::vector<std::string> names;
  int number = 0;
  for (const Station& station : network.stations) {
    std::string name = station.name;
    while (name.empty()) {
      name = std::to_string(++number);
      if (!taken.insert(name).second) name.clear();
    }
    names.push_back(std::move(name));
  }
  return names;
}

void add_equates(const Network& network, survey::Survey& survey) {
  for (size_t i = 0; i < network.stations.size(); ++i)
    for (const std::string& name : network.stations[i].equated) {
      survey.equates.push_back({static_cast<int>(i), static_cast<int>(survey.stations.size()), {}});
      survey.stations.push_back(survey.stations[i]);
      survey.stations.back().name = name;
    }
}

void add_splays(const Network& network, survey::Survey& survey) {
  for (size_t i = 0; i < network.stations.size(); ++i)
    for (const Vec3d& splay : network.stations[i].splays) {
      const auto wall = static_cast<int>(survey.stations.size());
      survey::Station station;
      station.position = to_survey(splay) + network.origin;
      station.underground = station.wall = true;
      survey.stations.push_back(std::move(station));
      survey::Leg leg;
      leg.from = static_cast<int>(i);
      leg.to = wall;
      leg.splay = true;
      survey.legs.push_back(std::move(leg));
    }
}

/// Tubes along branches, interrupted where a station has no cross-section; a station that is not in
/// a branch has a tube of its own.
void add_tubes(const Network& network, survey::Survey& survey) {
  std::vector<std::vector<int>> chains;
  std::vector<bool> on_branch(network.stations.size(), false);
  for (Branch& branch : reduce(network).branches) {
    for (const int station : branch.stations) on_branch[static_cast<size_t>(station)] = true;
    chains.push_back(std::move(branch.stations));
  }
  for (size_t i = 0; i < on_branch.size(); ++i)
    if (!on_branch[i]) chains.push_back({static_cast<int>(i)});
  for (const std::vector<int>& chain : chains) {
    survey::Tube tube;
    for (const int station : chain) {
      const auto& section = network.stations[static_cast<size_t>(station)].section;
      if (section)
        tube.push_back({station, section->left, section->right, section->up, section->down});
      if ((!section || station == chain.back()) && !tube.empty())
        survey.tubes.push_back(std::exchange(tube, {}));
    }
  }
}

}  // namespace

survey::Survey to_survey(const Network& network) {
  require_valid(network);
  survey::Survey survey;
  survey.coordinate_system = network.coordinate_system;
  std::vector<std::string> names = unique_names(network);
  for (size_t i = 0; i < network.stations.size(); ++i) {
    const Station& source = network.stations[i];
    survey::Station station;
    station.name = std::move(names[i]);
    station.position = to_survey(source.position) + network.origin;
    station.surface = source.flags.surface;
    station.underground = !source.flags.surface;
    station.entrance = source.flags.entrance;
    survey.stations.push_back(std::move(station));
  }
  for (const Leg& source : network.legs) {
    survey::Leg leg;
    leg.from = source.from;
    leg.to = source.to;
    leg.survey = source.survey;
    leg.surface = source.surface;
    leg.duplicate = source.duplicate;
    survey.legs.push_back(std::move(leg));
  }
  add_equates(network, survey);
  add_splays(network, survey);
  add_tubes(network, survey);
  return survey;
}

}  // namespace vug::network
