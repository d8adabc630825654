// SPDX-License-Identifier: Apache-2.0
#include <vug/network/from_survey.h>

#include <fmt/format.h>
#include <vug/base/disjoint_sets.h>
#include <vug/base/error.h>
#include <vug/network/survey_space.h>

#include <cmath>

namespace vug::network {
namespace {

/// A leg that is a splay, from a station of the network to a point on the wall.
struct Splay {
  int from = 0;
  int end = 0;
};

class Conversion {
 public:
  Conversion(const survey::Survey& survey, const FromSurveyOptions& options)
      : survey_(survey), options_(options) {}

  Network run() {
    require_valid_survey();
    merge_equated_stations();
    sort_legs();
    network_.coordinate_system = survey_.coordinate_system;
    network_.files = survey_.files;
    network_.origin = scene_origin(kept_points(), options_.place);
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
    for (const survey::Equate& equate : survey_.equates) {
      require_station(equate.a, equate.where);
      require_station(equate.b, equate.where);
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

  /// Finds for each station of the survey the first one that is equated to it, its point. From here
  /// on, stations are points.
  void merge_equated_stations() {
    const size_t count = survey_.stations.size();
    DisjointSets<int> sets(count);
    for (const survey::Equate& equate : survey_.equates) sets.join(equate.a, equate.b);
    names_.resize(count);
    for (size_t i = 0; i < count; ++i) {
      point_.push_back(sets.root(static_cast<int>(i)));
      if (!survey_.stations[i].anonymous())
        names_[static_cast<size_t>(point_[i])].push_back(survey_.stations[i].name);
    }
  }

  int point(int station) const { return point_[static_cast<size_t>(station)]; }
  bool anonymous(int point) const { return names_[static_cast<size_t>(point)].empty(); }

  /// Separates splays from the legs of the network and marks the points that remain.
  void sort_legs() {
    kept_.resize(survey_.stations.size());
    for (size_t i = 0; i < kept_.size(); ++i) kept_[i] = !anonymous(static_cast<int>(i));
    for (const survey::Leg& leg : survey_.legs) {
      if (leg.surface && !options_.surface) continue;
      if (leg.duplicate && !options_.duplicates && !leg.splay) continue;
      const int from = point(leg.from), to = point(leg.to);
      if (leg.splay || anonymous(from) != anonymous(to)) {
        splays_.push_back(anonymous(from) ? Splay{to, from} : Splay{from, to});
        continue;
      }
      if (from == to && leg.from != leg.to) continue;  // A leg between equated stations.
      legs_.push_back(&leg);
      kept_[static_cast<size_t>(from)] = kept_[static_cast<size_t>(to)] = true;
    }
    drop_ends_of_splays();
    if (!options_.surface) drop_surface_stations();
  }

  /// A named station at the end of a splay that has no other leg is a point on the wall.
  void drop_ends_of_splays() {
    std::vector<bool> on_leg(kept_.size(), false);
    for (const survey::Leg* leg : legs_)
      on_leg[static_cast<size_t>(point(leg->from))] = on_leg[static_cast<size_t>(point(leg->to))] =
          true;
    for (const Splay& splay : splays_) on_leg[static_cast<size_t>(splay.from)] = true;
    for (const Splay& splay : splays_)
      if (!on_leg[static_cast<size_t>(splay.end)]) kept_[static_cast<size_t>(splay.end)] = false;
    for (const Splay& splay : splays_) kept_[static_cast<size_t>(splay.from)] = true;
  }

  void drop_surface_stations() {
    std::vector<bool> used(kept_.size(), false);
    std::vector<bool> on_surface(kept_.size(), false);
    for (const survey::Leg* leg : legs_)
      used[static_cast<size_t>(point(leg->from))] = used[static_cast<size_t>(point(leg->to))] =
          true;
    for (const Splay& splay : splays_) used[static_cast<size_t>(splay.from)] = true;
    for (const survey::Leg& leg : survey_.legs)
      if (leg.surface)
        on_surface[static_cast<size_t>(point(leg.from))] =
            on_surface[static_cast<size_t>(point(leg.to))] = true;
    for (size_t i = 0; i < kept_.size(); ++i)
      if (on_surface[i] && !used[i]) kept_[i] = false;
  }

  std::vector<NamedPoint> kept_points() const {
    std::vector<NamedPoint> points;
    for (size_t i = 0; i < kept_.size(); ++i)
      if (kept_[i]) points.push_back({survey_.stations[i].name, survey_.stations[i].position});
    return points;
  }

  Vec3d scene_position(int station) const {
    return to_scene(survey_.stations[static_cast<size_t>(station)].position - network_.origin);
  }

  void add_stations() {
    index_.assign(kept_.size(), -1);
    for (size_t i = 0; i < kept_.size(); ++i) {
      if (!kept_[i]) continue;
      index_[i] = static_cast<int>(network_.stations.size());
      Station station{.position = scene_position(static_cast<int>(i)), .flags = {.surface = true}};
      if (!names_[i].empty()) station.name = names_[i].front();
      for (size_t k = 1; k < names_[i].size(); ++k) station.equated.push_back(names_[i][k]);
      network_.stations.push_back(std::move(station));
    }
    for (size_t i = 0; i < point_.size(); ++i) {
      if (index_[static_cast<size_t>(point_[i])] < 0) continue;
      StationFlags& flags = kept_station(point_[i]).flags;
      flags.entrance |= survey_.stations[i].entrance;
      flags.surface &= survey_.stations[i].surface;
    }
    for (const Splay& splay : splays_)
      kept_station(splay.from).splays.push_back(scene_position(splay.end));
  }

  int kept_index(int point) const { return index_[static_cast<size_t>(point)]; }
  Station& kept_station(int point) {
    return network_.stations[static_cast<size_t>(kept_index(point))];
  }

  void add_legs() {
    for (const survey::Leg* leg : legs_)
      network_.legs.push_back({.from = kept_index(point(leg->from)),
                               .to = kept_index(point(leg->to)),
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
        const int at = point(source.station);
        if (kept_index(at) < 0) continue;
        const CrossSection section{source.left, source.right, source.up, source.down};
        std::optional<CrossSection>& best = kept_station(at).section;
        if (distances(section) > (best ? distances(*best) : 0)) best = section;
      }
  }

  const survey::Survey& survey_;
  FromSurveyOptions options_;
  Network network_;
  std::vector<const survey::Leg*> legs_;
  std::vector<Splay> splays_;
  std::vector<int> point_;                       ///< By station of the survey.
  std::vector<std::vector<std::string>> names_;  ///< By point.
  std::vector<bool> kept_;                       ///< By point.
  std::vector<int> index_;                       ///< Index in the network, or -1, by point.
};

}  // namespace

Network from_survey(const survey::Survey& survey, const FromSurveyOptions& options) {
  Network network = Conversion(survey, options).run();
  require_valid(network);
  return network;
}

}  // namespace vug::network
