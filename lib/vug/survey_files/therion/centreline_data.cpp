// SPDX-License-Identifier: Apache-2.0
// Lines of data of a centreline: legs, stations and distances to the walls.
#include <vug/survey_files/plausible.h>
#include <vug/survey_files/therion/centreline.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::survey::therion {
namespace {

bool is_anonymous(const std::string& name) { return name == "." || name == "-"; }

}  // namespace

int Centreline::station(const Token& name) {
  if (is_anonymous(name.text)) return context_.stations.add_anonymous(name.text == "-", name.where);
  Token complete = name;
  complete.text = settings_.prefix + name.text + settings_.suffix;
  return context_.stations.find_or_add(full_name(complete, path_), name.where);
}

void Centreline::read_data(const std::vector<Token>& line) {
  const Order& order = settings_.order;
  if (order.interleaved) return read_interleaved(line);
  const DataLine data = read_data_line(line, order, 0, order.items.size());
  if (order.style == DataStyle::passage)
    add_dimensions(data);
  else
    add_leg(data);
}

void Centreline::read_interleaved(const std::vector<Token>& line) {
  const std::vector<Item>& items = settings_.order.items;
  const auto middle =
      static_cast<size_t>(std::find(items.begin(), items.end(), Item::newline) - items.begin());
  if (!expects_station_) {
    leg_ = read_data_line(line, settings_.order, middle + 1, items.size());
    if (leg_->station)
      fail("the order names the station after 'newline'", leg_->where,
           "write for example: data normal station newline length compass clino");
    expects_station_ = true;
    return;
  }
  DataLine here = read_data_line(line, settings_.order, 0, middle);
  if (!here.station)
    fail("the order names no station before 'newline'", here.where,
         "write for example: data normal station newline length compass clino");
  if (last_ && leg_) {
    DataLine leg = *leg_;
    leg.from = last_->station;
    leg.to = here.station;
    leg.where = leg_->where;
    // Depths and counts are those of the stations; walls belong to the end of the leg.
    const Values before = last_->values;
    leg.values.add(here.values);
    leg.values[Item::from_depth] = before[Item::depth];
    leg.values[Item::to_depth] = here.values[Item::depth];
    leg.values[Item::from_count] = before[Item::count];
    leg.values[Item::to_count] = here.values[Item::count];
    add_leg(leg);
  }
  last_ = std::move(here);
  leg_.reset();
  expects_station_ = false;
}

CrossSection Centreline::section(int station, const Values& values, bool second) const {
  const auto side = [&](Item item, Quantity quantity) -> std::optional<double> {
    const Value& value = values[item];
    if (!value.is_number()) return std::nullopt;
    const double raw = second && value.second ? *value.second : value.number;
    if (raw < 0)
      fail(fmt::format("the distance {} to a wall is negative", raw), value.where,
           "write - for an unknown distance");
    const double distance = settings_.calibrations[quantity](raw);
    require_plausible_wall(distance, value.where);
    return distance;
  };
  return {station, side(Item::left, kLeft), side(Item::right, kRight), side(Item::up, kUp),
          side(Item::down, kDown)};
}

void Centreline::add_dimensions(const DataLine& line) {
  for (const Item item : {Item::left, Item::right, Item::up, Item::down})
    if (line.values[item].second)
      fail("a pair of distances needs a leg", line.values[item].where, "write one number");
  std::vector<Tube>& tubes = context_.observations.tubes;
  const int at = station(*line.station);
  if (new_tube_) tubes.emplace_back();
  new_tube_ = false;
  tubes.back().push_back(section(at, line.values, false));
  tube_end_ = -1;
}

/// Walls belong to the station at which a leg ends; of pairs, the first number to its start.
void Centreline::add_sections(int from, int to, const Values& values) {
  bool any = false, pair = false;
  for (const Item item : {Item::left, Item::right, Item::up, Item::down}) {
    any = any || values[item].is_number();
    pair = pair || values[item].second.has_value();
  }
  if (!any) {
    new_tube_ = true;
    return;
  }
  std::vector<Tube>& tubes = context_.observations.tubes;
  if (new_tube_ || tube_end_ != from) {
    tubes.emplace_back();
    if (pair) tubes.back().push_back(section(from, values, false));
  }
  new_tube_ = false;
  tubes.back().push_back(section(to, values, true));
  tube_end_ = to;
}

void Centreline::add_leg(DataLine line) {
  if (line.backwards) std::swap(line.from, line.to);
  const bool open = is_anonymous(line.from->text) || is_anonymous(line.to->text);
  if (is_anonymous(line.from->text) && is_anonymous(line.to->text))
    fail("a leg joins two anonymous stations", line.where, "name one of the stations");
  const LegVector vector = leg_vector(line, settings_, context_.warnings);
  require_plausible(vector.measured, line.where);
  const int from = station(*line.from), to = station(*line.to);
  if (from == to)
    fail(fmt::format("the leg leads from {} to itself", quote_text(line.from->text)), line.where,
         "name two stations");
  if (settings_.infer_equates && !open && vector.length == 0 &&
      settings_.order.style != DataStyle::nosurvey) {
    context_.observations.add(Equate{from, to, line.where});
    return;
  }
  ObservedLeg leg;
  leg.leg.from = from;
  leg.leg.to = to;
  leg.leg.style = leg_style(settings_.order.style);
  leg.leg.surface = settings_.surface;
  leg.leg.duplicate = settings_.duplicate;
  leg.leg.splay = settings_.splay || open;
  leg.leg.survey = path_;
  leg.leg.date = settings_.date;
  leg.leg.length = vector.length;
  leg.leg.where = line.where;
  leg.vector = vector.measured.vector;
  leg.covariance = vector.measured.covariance;
  context_.observations.legs.push_back(std::move(leg));
  if (!open) add_sections(from, to, line.values);
}

}  // namespace vug::survey::therion
