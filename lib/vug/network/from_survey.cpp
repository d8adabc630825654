// SPDX-License-Identifier: Apache-2.0
#include <vug/network/from_survey.h>

#include <fmt/format.h>
#include <vug/base/error.h>
#include <vug/network/survey_space.h>

#include <cmath>

namespace vug::network {
namespace {

/// A leg that is a splay, from a station of the network to a point on the wall.
struct Splay {
  int from = 0;
  int point = 0;
};

class Conversion {
 public:
  Conversion(const survey::Survey& survey, const FromSurveyOptions& options)
      : survey_(survey), options_(options) {}

  Network run() {
    require_valid_survey();
    sort_legs();
    network_.coordinate_system = survey_.coordinate_system;
    if (options_.recenter) network_.origin = rounded_middle(kept_positions());
    add_stations();
    add_legs();
    add_sections();
    return std::move(network_);
  }

 private:
  void require_valid_survey() const {
    for (size_t i = 0; i < survey_.stations.size(); ++i) {
      const survey::Station& station = survey_.stations[i];
      const Vec3d& p = station.position;
      if (!std::isfinite(p.x + p.y + p.z))
        throw Error(
            ErrorCode::bad_input,
            fmt::format("station {} ('{}') has a position that is not finite", i, station.name),
            station.where, "adjust the survey before it becomes a network");
    }
    for (const survey::Leg& leg : survey_.legs) {
      require_station(leg.from, leg.where);
      require_station(leg.to, leg.where);
    }
    for (const survey::Tube& tube : survey_.tubes)
      for (const survey::CrossSection& section : tube) require_station(section.station, {});
  }

  void require_station(int station, const SourceLocation& where) const {
    if (station < 0 || static_cast<size_t>(station) >= survey_.stations.size())
      throw Error(ErrorCode::bad_input,
                  fmt::format("station {} does not exist in a survey of {} stations", station,
                              survey_.stations.size()),
                  where, "stations count from 0");
  }

  const survey::Station& station(int index) const {
    return survey_.stations[static_cast<size_t>(index)];
  }

  /// Separates splays from the legs of the network and marks the stations that remain.
  void sort_legs() {
    kept_.resize(survey_.stations.size());
    for (size_t i = 0; i < kept_.size(); ++i) kept_[i] = !survey_.stations[i].anonymous();
    for (const survey::Leg& leg : survey_.legs) {
      if (leg.surface && !options_.surface) continue;
      if (leg.duplicate && !options_.duplicates && !leg.splay) continue;
      const bool from_wall = station(leg.from).anonymous();
      if (leg.splay || from_wall != station(leg.to).anonymous()) {
        splays_.push_back(from_wall ? Splay{leg.to, leg.from} : Splay{leg.from, leg.to});
        continue;
      }
      legs_.push_back(&leg);
      kept_[static_cast<size_t>(leg.from)] = kept_[static_cast<size_t>(leg.to)] = true;
    }
    drop_ends_of_splays();
    if (!options_.surface) drop_surface_stations();
  }

  /// A named station at the end of a splay that has no other leg is a point on the wall.
  void drop_ends_of_splays() {
    std::vector<bool> on_leg(kept_.size(), false);
    for (const survey::Leg* leg : legs_)
      on_leg[static_cast<size_t>(leg->from)] = on_leg[static_cast<size_t>(leg->to)] = true;
    for (const Splay& splay : splays_) on_leg[static_cast<size_t>(splay.from)] = true;
    for (const Splay& splay : splays_)
      if (!on_leg[static_cast<size_t>(splay.point)])
        kept_[static_cast<size_t>(splay.point)] = false;
    for (const Splay& splay : splays_) kept_[static_cast<size_t>(splay.from)] = true;
  }

  void drop_surface_stations() {
    std::vector<bool> used(kept_.size(), false);
    std::vector<bool> on_surface(kept_.size(), false);
    for (const survey::Leg* leg : legs_)
      used[static_cast<size_t>(leg->from)] = used[static_cast<size_t>(leg->to)] = true;
    for (const Splay& splay : splays_) used[static_cast<size_t>(splay.from)] = true;
    for (const survey::Leg& leg : survey_.legs)
      if (leg.surface)
        on_surface[static_cast<size_t>(leg.from)] = on_surface[static_cast<size_t>(leg.to)] = true;
    for (size_t i = 0; i < kept_.size(); ++i)
      if (on_surface[i] && !used[i]) kept_[i] = false;
  }

  std::vector<Vec3d> kept_positions() const {
    std::vector<Vec3d> positions;
    for (size_t i = 0; i < kept_.size(); ++i)
      if (kept_[i]) positions.push_back(survey_.stations[i].position);
    return positions;
  }

  Vec3d scene_position(int index) const {
    return to_scene(station(index).position - network_.origin);
  }

  void add_stations() {
    index_.assign(kept_.size(), -1);
    for (size_t i = 0; i < kept_.size(); ++i) {
      if (!kept_[i]) continue;
      index_[i] = static_cast<int>(network_.stations.size());
      const survey::Station& source = survey_.stations[i];
      network_.stations.push_back(
          {.name = source.name,
           .position = scene_position(static_cast<int>(i)),
           .flags = {.entrance = source.entrance, .surface = source.surface}});
    }
    for (const Splay& splay : splays_)
      kept_station(splay.from).splays.push_back(scene_position(splay.point));
  }

  Station& kept_station(int index) {
    return network_.stations[static_cast<size_t>(index_[static_cast<size_t>(index)])];
  }

  void add_legs() {
    for (const survey::Leg* leg : legs_)
      network_.legs.push_back({.from = index_[static_cast<size_t>(leg->from)],
                               .to = index_[static_cast<size_t>(leg->to)],
                               .survey = leg->survey,
                               .surface = leg->surface,
                               .duplicate = leg->duplicate});
  }

  static int distances(const CrossSection& section) {
    return section.left.has_value() + section.right.has_value() + section.up.has_value() +
           section.down.has_value();
  }

  void add_sections() {
    for (const survey::Tube& tube : survey_.tubes)
      for (const survey::CrossSection& source : tube) {
        if (index_[static_cast<size_t>(source.station)] < 0) continue;
        const CrossSection section{source.left, source.right, source.up, source.down};
        std::optional<CrossSection>& best = kept_station(source.station).section;
        if (distances(section) > (best ? distances(*best) : 0)) best = section;
      }
  }

  const survey::Survey& survey_;
  FromSurveyOptions options_;
  Network network_;
  std::vector<const survey::Leg*> legs_;
  std::vector<Splay> splays_;
  std::vector<bool> kept_;
  std::vector<int> index_;  ///< Index in the network, or -1, by station.
};

}  // namespace

Network from_survey(const survey::Survey& survey, const FromSurveyOptions& options) {
  Network network = Conversion(survey, options).run();
  require_valid(network);
  return network;
}

}  // namespace vug::network
