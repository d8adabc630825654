// SPDX-License-Identifier: Apache-2.0
#include <vug/passages/simulated_survey.h>

#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/base/rng.h>
#include <vug/network/from_survey.h>
#include <vug/passages/curves/chains.h>
#include <vug/passages/curves/curve.h>
#include <vug/passages/curves/frames.h>
#include <vug/passages/distance_to_wall.h>
#include <vug/passages/survey_line.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vug::passages {
namespace {

constexpr int kMostSplays = 1000;
constexpr double kMostLegs = 1e6;
constexpr double kMostShift = 3;  ///< Metres by which stations are moved into the air.

void require_valid(const SimulationOptions& o) {
  const auto require = [](bool valid, const char* name, double value, const char* expected) {
    if (!valid)
      throw Error(ErrorCode::bad_input,
                  fmt::format("the {} of the simulated survey is {}", name, value), {}, expected);
  };
  require(o.longest_leg > 0, "longest leg", o.longest_leg, "it must be above 0 metres");
  require(o.splays >= 0 && o.splays <= kMostSplays, "number of splays", o.splays,
          "it must be in 0 to 1000 for each station");
  require(o.tilt >= 0 && o.tilt <= kPi / 4, "tilt", o.tilt, "it must be in 0 to pi/4 radians");
  require(o.reach > 0 && std::isfinite(o.reach), "reach", o.reach,
          "it must be above 0 and finite, in metres");
}

/// The line of the survey along a chain of the network.
struct Line {
  std::vector<int> stations;  ///< One more than legs.
  std::vector<int> legs;      ///< The legs of the network of which these are parts.
  bool start_meets = false;   ///< See Chain.
  bool end_meets = false;

  void add(int leg, int station) {
    legs.push_back(leg);
    stations.push_back(station);
  }
};

/// A station at which walls are measured, and the directions across the passage.
struct Setup {
  int station = 0;
  Frame frame;
};

class Simulation {
 public:
  Simulation(const field::Field& field, const network::Network& network,
             const SimulationOptions& options)
      : field_(field), source_(network), options_(options), index_(network.stations.size(), -1) {
    measured_.origin = network.origin;
    measured_.coordinate_system = network.coordinate_system;
  }

  SimulatedSurvey run() {
    const std::vector<Chain> all = chains(source_);
    require_few_legs(all);
    for (const Chain& chain : all) lines_.push_back(line_of(chain));
    if (lines_.empty())
      throw Error(ErrorCode::bad_input, "the network has no legs underground", {},
                  "a survey needs at least one leg that does not run over the surface");
    const Air air(field_, most_are_negative());
    move_into(air);
    for (Line& line : lines_) bend_around_rock(air, line);
    for (const Line& line : lines_) add_legs(line);
    parallel_for(setups_.size(), [&](size_t i) { measure(air, setups_[i]); });
    SimulatedSurvey out{network::to_survey(measured_), 0};
    out.survey.tubes = tubes();
    for (survey::Leg& leg : out.survey.legs) set_readings(out.survey, leg);
    for (const network::Station& station : measured_.stations) out.in_rock += !station.section;
    return out;
  }

 private:
  /// The number of legs into which one of the network is divided.
  double legs_for(double length) const {
    return std::max(1.0, std::ceil(length / options_.longest_leg - 1e-9));
  }

  void require_few_legs(const std::vector<Chain>& all) const {
    double count = 0;
    for (const Chain& chain : all)
      for (const int leg : chain.legs)
        count +=
            legs_for(network::leg_vector(source_, source_.legs[static_cast<size_t>(leg)]).length());
    if (count > kMostLegs)
      throw Error(ErrorCode::too_large,
                  fmt::format("the simulated survey has {:.3g} legs, more than a million", count),
                  {}, "allow longer legs");
  }

  /// The station of the survey for one of the network.
  int station_of(int source) {
    int& index = index_[static_cast<size_t>(source)];
    if (index < 0) {
      network::Station station = source_.stations[static_cast<size_t>(source)];
      station.section.reset();
      station.splays.clear();
      index = add_station(std::move(station));
    }
    return index;
  }

  int add_station(network::Station station) {
    measured_.stations.push_back(std::move(station));
    return static_cast<int>(measured_.stations.size()) - 1;
  }

  /// The stations along a chain, at most the longest leg apart.
  Line line_of(const Chain& chain) {
    Line line{{station_of(chain.stations[0])}, {}, chain.start_meets, chain.end_meets};
    for (size_t i = 0; i < chain.legs.size(); ++i) {
      const int end = station_of(chain.stations[i + 1]);
      const Vec3d from = position(line.stations.back()), step = position(end) - from;
      const double pieces = legs_for(step.length());
      for (double k = 1; k < pieces; ++k)
        line.add(chain.legs[i], add_station({.position = from + step * (k / pieces)}));
      line.add(chain.legs[i], end);
    }
    return line;
  }

  /// Moves stations in the rock, or too near to a wall, into the air.
  void move_into(const Air& air) {
    parallel_for(measured_.stations.size(), [&](size_t i) {
      Vec3d& p = measured_.stations[i].position;
      p = air.nearest(p, kMostShift).value_or(p);
    });
  }

  /// Adds stations where rock hides the end of a leg from its start.
  void bend_around_rock(const Air& air, Line& line) {
    std::vector<std::vector<Vec3d>> bends(line.legs.size());
    parallel_for(bends.size(), [&](size_t i) {
      const Vec3d &from = position(line.stations[i]), &to = position(line.stations[i + 1]);
      if (air.contains(from) && air.contains(to)) bends[i] = air.bends(from, to, kMostShift);
    });
    Line bent{{line.stations[0]}, {}, line.start_meets, line.end_meets};
    for (size_t i = 0; i < bends.size(); ++i) {
      for (const Vec3d& p : bends[i]) bent.add(line.legs[i], add_station({.position = p}));
      bent.add(line.legs[i], line.stations[i + 1]);
    }
    line = std::move(bent);
  }

  void add_legs(const Line& line) {
    for (size_t i = 0; i < line.legs.size(); ++i) {
      network::Leg leg = source_.legs[static_cast<size_t>(line.legs[i])];
      leg.from = line.stations[i];
      leg.to = line.stations[i + 1];
      measured_.legs.push_back(std::move(leg));
    }
    add_setups(line);
  }

  /// Walls are measured once at each station, along the passage that does not end there.
  void add_setups(const Line& line) {
    const std::vector<int>& path = line.stations;
    Curve curve(path.size());
    std::vector<Vec3d> points;
    for (size_t i = 0; i < path.size(); ++i)
      points.push_back(curve[i].position = position(path[i]));
    const std::vector<Frame> across = frames(points, tangents(curve));
    const bool omit_last = line.end_meets || path.front() == path.back();
    std::vector<int> tube;
    for (size_t i = line.start_meets; i + omit_last < path.size(); ++i) {
      setups_.push_back({path[i], across[i]});
      tube.push_back(path[i]);
    }
    tubes_.push_back(std::move(tube));
  }

  const Vec3d& position(int station) const {
    return measured_.stations[static_cast<size_t>(station)].position;
  }

  bool most_are_negative() const {
    size_t negative = 0;
    for (const network::Station& station : measured_.stations)
      negative += field_.value(station.position) < 0;
    return 2 * negative >= measured_.stations.size();
  }

  void measure(const Air& air, const Setup& setup) {
    network::Station& station = measured_.stations[static_cast<size_t>(setup.station)];
    const Vec3d& p = station.position;
    if (!air.contains(p)) return;
    const auto distance = [&](const Vec3d& direction) {
      return distance_to_wall(field_, p, direction, options_.reach);
    };
    const auto& [right, up] = setup.frame;
    station.section = {distance(right * -1.0), distance(right), distance(up), distance(up * -1.0)};
    RandomStream random(
        RandomKey(options_.seed).at("splays").at(static_cast<uint64_t>(setup.station)));
    const double start = random.uniform();
    for (int i = 0; i < options_.splays; ++i) {
      const double angle = 2 * kPi * (i + start) / options_.splays;
      const double tilt = random.uniform(-options_.tilt, options_.tilt);
      const Vec3d direction =
          (right * maths::cos(angle) + up * maths::sin(angle)) * maths::cos(tilt) +
          up.cross(right) * maths::sin(tilt);
      if (const auto length = distance(direction))
        station.splays.push_back(p + direction * *length);
    }
  }

  /// The cross-sections along each chain, interrupted at stations in the rock.
  std::vector<survey::Tube> tubes() const {
    std::vector<survey::Tube> out;
    for (const std::vector<int>& stations : tubes_) {
      survey::Tube tube;
      for (const int station : stations) {
        if (const auto& s = measured_.stations[static_cast<size_t>(station)].section)
          tube.push_back({station, s->left, s->right, s->up, s->down});
        else if (!tube.empty())
          out.push_back(std::exchange(tube, {}));
      }
      if (!tube.empty()) out.push_back(std::move(tube));
    }
    return out;
  }

  static void set_readings(const survey::Survey& survey, survey::Leg& leg) {
    const Vec3d vector = survey.stations[static_cast<size_t>(leg.to)].position -
                         survey.stations[static_cast<size_t>(leg.from)].position;
    leg.style = survey::Style::normal;
    leg.length = vector.length();
    leg.plan_length = std::sqrt(vector.x * vector.x + vector.y * vector.y);
    leg.vertical_length = std::abs(vector.z);
  }

  const field::Field& field_;
  const network::Network& source_;
  const SimulationOptions& options_;
  network::Network measured_;
  std::vector<int> index_;  ///< In measured_, or -1, of each station of the source.
  std::vector<Line> lines_;
  std::vector<std::vector<int>> tubes_;  ///< The stations of each line that have a setup.
  std::vector<Setup> setups_;
};

}  // namespace

SimulatedSurvey simulate_survey(const field::Field& field, const network::Network& network,
                                const SimulationOptions& options) {
  network::require_valid(network);
  require_valid(options);
  return Simulation(field, network, options).run();
}

}  // namespace vug::passages
