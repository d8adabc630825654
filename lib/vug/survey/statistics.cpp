// SPDX-License-Identifier: Apache-2.0
#include <vug/survey/statistics.h>

#include <vug/base/disjoint_sets.h>

#include <cmath>

namespace vug::survey {
namespace {

void extend(Extent& extent, double value, int station) {
  if (extent.low_station < 0 || value < extent.low)
    extent.low = value, extent.low_station = station;
  if (extent.high_station < 0 || value > extent.high)
    extent.high = value, extent.high_station = station;
}

void measure_extents(const Survey& survey, Statistics& out) {
  for (size_t i = 0; i < survey.stations.size(); ++i) {
    const Station& station = survey.stations[i];
    if (station.anonymous() || (station.surface && !station.underground)) continue;
    extend(out.east, station.position.x, static_cast<int>(i));
    extend(out.north, station.position.y, static_cast<int>(i));
    extend(out.altitude, station.position.z, static_cast<int>(i));
  }
}

void measure_lengths(const Survey& survey, Statistics& out) {
  for (const Leg& leg : survey.legs) {
    if (leg.style == Style::nosurvey) continue;
    const Vec3d between = survey.stations[static_cast<size_t>(leg.to)].position -
                          survey.stations[static_cast<size_t>(leg.from)].position;
    const bool measured = leg.length != 0;
    const double length = measured ? leg.length : between.length();
    if (leg.splay) ++out.splays;
    if (leg.splay) continue;
    if (leg.surface) out.surface_length += length;
    if (!leg.surface && leg.duplicate) out.duplicate_length += length;
    if (leg.surface || leg.duplicate) continue;
    out.length += length;
    out.adjusted_length += between.length();
    out.plan_length += measured ? leg.plan_length : std::hypot(between.x, between.y);
    out.vertical_length += measured ? leg.vertical_length : std::fabs(between.z);
  }
}

}  // namespace

Statistics measure(const Survey& survey) {
  Statistics out;
  DisjointSets<int> sets(survey.stations.size()), equal(survey.stations.size());
  std::vector<int> degrees(survey.stations.size(), 0);
  const auto connect = [&](int a, int b) {
    ++out.legs;
    ++degrees[static_cast<size_t>(a)];
    ++degrees[static_cast<size_t>(b)];
    sets.join(a, b);
  };
  for (const Leg& leg : survey.legs)
    if (leg.style != Style::nosurvey) connect(leg.from, leg.to);
  for (const Equate& each : survey.equates) {
    if (!equal.join(each.a, each.b)) continue;
    ++out.equates;
    connect(each.a, each.b);
  }
  out.stations = static_cast<int>(survey.stations.size());
  for (int i = 0; i < out.stations; ++i) {
    if (sets.root(i) == i) ++out.components;
    ++out.degrees[degrees[static_cast<size_t>(i)]];
  }
  const int excess = out.legs - out.stations;
  out.loops = excess + out.components;
  out.survex_components = survey.survex_components;
  if (out.survex_components) out.survex_loops = excess + *out.survex_components;
  for (const Tube& tube : survey.tubes) out.cross_sections += static_cast<int>(tube.size());
  measure_extents(survey, out);
  measure_lengths(survey, out);
  return out;
}

}  // namespace vug::survey
