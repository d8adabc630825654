// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/shortest_paths.h>
#include <vug/passages/lines/route.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

using network::Network;
using LegsAtStations = std::vector<std::vector<int>>;

/// The station itself if it is on a leg, else the nearest one that is; -1 without legs.
int nearest_on_legs(const Network& course, const LegsAtStations& legs_at, int station) {
  if (!legs_at[static_cast<size_t>(station)].empty()) return station;
  const Vec3d& at = course.stations[static_cast<size_t>(station)].position;
  int best = -1;
  double least = kInfinity;
  for (size_t i = 0; i < legs_at.size(); ++i) {
    const double distance = (course.stations[i].position - at).length2();
    if (legs_at[i].empty() || distance >= least) continue;
    least = distance;
    best = static_cast<int>(i);
  }
  return best;
}

/// The stations on the shortest way; empty if no way exists.
std::vector<int> shortest_way(const Network& course, const LegsAtStations& legs_at, int from,
                              int to) {
  const auto for_each_leg = [&](int station, const auto& relax) {
    for (const int index : legs_at[static_cast<size_t>(station)]) {
      const network::Leg& leg = course.legs[static_cast<size_t>(index)];
      relax(leg.from == station ? leg.to : leg.from, index,
            network::leg_vector(course, leg).length());
    }
  };
  const SearchTree tree =
      shortest_paths(course.stations.size(), from, for_each_leg,
                     [&](int station) { return station == to ? Visit::stop : Visit::expand; });
  return tree.reached < 0 ? std::vector<int>{} : tree.path_to(to);
}

double half_of_smaller(const network::CrossSection& section) {
  return 0.5 * std::min(section.left.value_or(0) + section.right.value_or(0),
                        section.up.value_or(0) + section.down.value_or(0));
}

}  // namespace

Route::Route(const Network& course, int from, int to) {
  network::require_valid(course);
  const LegsAtStations legs_at = network::legs_at_stations(course);
  const int start = nearest_on_legs(course, legs_at, from);
  if (start < 0)
    throw Error(ErrorCode::bad_input, "the network has no passages", {},
                "give it legs with a length that do not run over the surface");
  const std::vector<int> way =
      shortest_way(course, legs_at, start, nearest_on_legs(course, legs_at, to));
  const auto name = [&](int i) { return course.stations[static_cast<size_t>(i)].name; };
  if (way.empty())
    throw Error(ErrorCode::bad_input,
                fmt::format("no passage leads from '{}' to '{}'", name(from), name(to)), {},
                "choose two stations of one cave; legs over the surface are not passages");
  for (const int i : way) {
    const network::Station& station = course.stations[static_cast<size_t>(i)];
    const double step = points_.empty() ? 0 : (station.position - points_.back()).length();
    if (!points_.empty() && !(step > 0)) continue;
    along_.push_back(points_.empty() ? 0 : along_.back() + step);
    points_.push_back(station.position);
    sizes_.push_back(station.section ? half_of_smaller(*station.section) : 0);
  }
}

size_t Route::piece(double s) const {
  const auto after = std::upper_bound(along_.begin(), along_.end(), s);
  const auto i = static_cast<size_t>(std::max<std::ptrdiff_t>(after - along_.begin() - 1, 0));
  return std::min(i, points_.size() - 2);
}

Vec3d Route::on_legs(double s) const {
  const size_t i = piece(s);
  return points_[i] +
         (points_[i + 1] - points_[i]) * ((s - along_[i]) / (along_[i + 1] - along_[i]));
}

double Route::half_size(double s) const {
  const size_t i = piece(s);
  const double t = (s - along_[i]) / (along_[i + 1] - along_[i]);
  return sizes_[i] + (sizes_[i + 1] - sizes_[i]) * std::clamp(t, 0.0, 1.0);
}

Vec3d Route::point(double s) const {
  if (points_.size() < 2) return points_[0];
  if (!(s > 0 && s < length())) return on_legs(s);
  constexpr int kSamples = 16;
  const double reach = std::min({half_size(s), s, length() - s});
  Vec3d sum(0.0);
  for (int i = 0; i < kSamples; ++i) sum += on_legs(s + reach * ((2 * i + 1.0) / kSamples - 1));
  return sum / kSamples;
}

}  // namespace vug::passages
