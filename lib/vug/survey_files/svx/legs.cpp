// SPDX-License-Identifier: Apache-2.0
#include <vug/survey_files/svx/legs.h>

#include <vug/survey_files/plausible.h>
#include <vug/survey_files/svx/vectors.h>

#include <fmt/format.h>

namespace vug::survey::svx {
namespace {

void require_valid_ends(Reader& reader, const LegLine& line) {
  if (line.from.anonymous && line.to.anonymous)
    throw Error(ErrorCode::bad_input, "both stations of the leg are anonymous",
                line.line.range(line.from.start), "one end of a leg must have a name");
  if (line.from.station == line.to.station)
    throw Error(
        ErrorCode::bad_input,
        fmt::format("both stations of the leg are '{}'", reader.stations[line.from.station].name),
        line.line.range(line.from.start), "a leg connects two stations");
}

double mean_with(double mean, double value, int count) { return mean + (value - mean) / count; }

/// Averages the measurements of a leg, as cavern 1.4.4 does: the covariance is the mean, too, as if
/// the errors of all were the same.
void add_measurement(ObservedLeg& leg, const ObservedLeg& again, int count) {
  for (int axis = 0; axis < 3; ++axis)
    leg.vector[axis] = mean_with(leg.vector[axis], again.vector[axis], count);
  for (double Covariance::*part : {&Covariance::xx, &Covariance::yy, &Covariance::zz,
                                   &Covariance::xy, &Covariance::yz, &Covariance::zx})
    leg.covariance.*part = mean_with(leg.covariance.*part, again.covariance.*part, count);
  leg.leg.length = mean_with(leg.leg.length, again.leg.length, count);
}

/// A leg from the same to the same station as the leg before measures it again.
void add_or_average(Reader& reader, ObservedLeg&& observed) {
  std::vector<ObservedLeg>& legs = reader.out.legs;
  const Leg& leg = observed.leg;
  const bool again = reader.repetitions > 0 && legs.back().leg.from == leg.from &&
                     legs.back().leg.to == leg.to && leg.style != Style::nosurvey;
  if (again) return add_measurement(legs.back(), observed, ++reader.repetitions);
  reader.repetitions = leg.style == Style::nosurvey ? 0 : 1;
  legs.push_back(std::move(observed));
}

}  // namespace

void add_leg(Reader& reader, const LegLine& line) {
  require_valid_ends(reader, line);
  const Settings& settings = reader.settings;
  const LegVector read = leg_vector(reader, line);
  ObservedLeg observed;
  observed.vector = read.measured.vector;
  observed.covariance = read.measured.covariance;
  Leg& leg = observed.leg;
  leg.from = line.backwards ? line.to.station : line.from.station;
  leg.to = line.backwards ? line.from.station : line.to.station;
  leg.style = leg_style(settings.order->style);
  leg.where = line.line.range(line.from.start);
  require_plausible(read.measured, leg.where);
  for (const int station : {leg.from, leg.to}) reader.stations.use(station);
  if (settings.infer_equates && read.length == 0 && leg.style != Style::nosurvey) {
    reader.out.add(Equate{leg.from, leg.to, leg.where});
    reader.repetitions = 0;
    return;
  }
  leg.surface = settings.surface;
  leg.duplicate = settings.duplicate;
  leg.splay = settings.splay || line.from.splay || line.to.splay;
  leg.length = read.length;
  leg.survey = settings.survey;
  leg.date = settings.date;
  add_or_average(reader, std::move(observed));
}

void add_cross_section(Reader& reader, const StationName& station, const ItemValues& values,
                       const Line& line) {
  if (station.anonymous)
    throw Error(ErrorCode::bad_input, "an anonymous station has no cross-section",
                line.range(station.start), "name a station of a leg");
  CrossSection section{station.station, {}, {}, {}, {}};
  const auto distance = [&](Item item, Quantity quantity, std::optional<double>& out) {
    if (!values[item].is_number()) return;
    const double metres = reader.settings.calibrations[quantity](values[item].number);
    if (metres >= 0) {
      require_plausible_wall(metres, line.word_at(values[item].start));
      out = metres;
      return;
    }
    reader.warnings.warning(line.word_at(values[item].start),
                            "a distance to a wall is negative and is ignored",
                            "write '-' for a distance that was not measured");
  };
  distance(Item::left, kLeft, section.left);
  distance(Item::right, kRight, section.right);
  distance(Item::up, kUp, section.up);
  distance(Item::down, kDown, section.down);
  if (!reader.in_tube) reader.out.tubes.emplace_back();
  reader.in_tube = true;
  reader.out.tubes.back().push_back(section);
}

}  // namespace vug::survey::svx
