// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/scout/candidates.h>
#include <vug/scout/trace_view.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace vug::scout {
namespace {

constexpr double kStanding = 1.6, kCrouching = 0.7;  // metres from the floor to the eye
constexpr double kOverhead = 0.35;                   // metres from the eye to the ceiling
constexpr double kHorizon = 60;                      // metres: longer views are all the same
constexpr size_t kRays = 48;                         // of a panorama

/// Places in the order of a hash, each at least `apart` from those before it, with the largest
/// distance that leaves enough of them.
std::vector<Stand> spread(const std::vector<Stand>& floor, RandomKey key, size_t wanted) {
  std::vector<std::pair<uint64_t, size_t>> order;
  for (size_t i = 0; i < floor.size(); ++i) order.emplace_back(key.at(i).state(), i);
  std::sort(order.begin(), order.end());
  std::vector<Stand> chosen;
  for (double apart = 16; apart > 0.4; apart *= 0.75) {
    chosen.clear();
    for (const auto& hashed : order) {
      const Stand& stand = floor[hashed.second];
      const auto is_near = [&](const Stand& other) {
        return (other.floor - stand.floor).length() < apart;
      };
      if (chosen.size() < wanted && std::none_of(chosen.begin(), chosen.end(), is_near))
        chosen.push_back(stand);
    }
    if (chosen.size() >= wanted) break;
  }
  return chosen;
}

double panorama_azimuth(size_t ray) {
  return 2 * kPi * static_cast<double>(ray) / static_cast<double>(kRays);
}

/// How far one sees in the direction of each ray of a panorama: the mean logarithm of the distances
/// within 22 degrees.
std::array<double, kRays> panorama(const render::PreparedScene& world, const Vec3d& eye) {
  std::array<double, kRays> sharp{}, smooth{};
  for (size_t i = 0; i < kRays; ++i) {
    const Pose pose{eye, panorama_azimuth(i), 4 * kDegree, 1};
    const Seen seen = look_along(world, eye, view_direction(pose));
    sharp[i] = maths::log(std::clamp(static_cast<double>(seen.distance), 0.1, kHorizon));
  }
  for (size_t i = 0; i < kRays; ++i)
    for (size_t k = 0; k <= 6; ++k) smooth[i] += sharp[(i + kRays + k - 3) % kRays] / 7;
  return smooth;
}

/// The ray with the longest view that deviates by at least 70 degrees from all azimuths so far.
std::optional<double> next_azimuth(const std::array<double, kRays>& views,
                                   const std::vector<double>& known) {
  std::optional<size_t> best;
  for (size_t i = 0; i < kRays; ++i) {
    const bool is_new = std::all_of(known.begin(), known.end(), [&](double azimuth) {
      return azimuth_between(azimuth, panorama_azimuth(i)) > 70 * kDegree;
    });
    if (is_new && (!best || views[i] > views[*best])) best = i;
  }
  if (!best) return std::nullopt;
  return panorama_azimuth(*best);
}

/// The direction to a subject that the eye sees; nothing if it does not.
std::optional<Vec3d> direction_to(const render::PreparedScene& world, const Vec3d& eye,
                                  const Subject& subject) {
  const Vec3d way = subject.position - eye;
  const double distance = way.length();
  if (distance < 1.5 || distance > 25) return std::nullopt;
  const Seen seen = look_along(world, eye, way);
  if (static_cast<double>(seen.distance) < distance - subject.size) return std::nullopt;
  return way / distance;
}

std::vector<Candidate> candidates_at(const render::PreparedScene& world, const Stand& stand,
                                     const std::vector<Subject>& subjects, RandomKey key) {
  RandomStream random(key);
  const bool low = random.uniform() < 0.2 || stand.headroom < kStanding + kOverhead;
  if (stand.headroom < kCrouching + kOverhead) return {};
  const Vec3d eye = stand.floor + Vec3d(0, low ? kCrouching : kStanding, 0);
  const std::array<double, kRays> views = panorama(world, eye);
  std::vector<double> azimuths = {*next_azimuth(views, {})};
  if (const auto back = next_azimuth(views, azimuths)) azimuths.push_back(*back);
  const double side = random.uniform() < 0.5 ? 25 * kDegree : -25 * kDegree;
  azimuths.push_back(azimuths[0] + side);
  azimuths.push_back(azimuths[1 % azimuths.size()] - side);
  constexpr double kLenses[] = {50, 65, 75};
  std::vector<Candidate> out;
  const auto add = [&](double azimuth, double pitch, Framing framing) {
    const double fov = kLenses[random.below(3)] * kDegree;
    if (framing == Framing::normal && fov > 74 * kDegree) framing = Framing::wide;
    if (framing == Framing::normal || framing == Framing::wide)
      if (low) framing = Framing::low;
    out.push_back({{eye, azimuth, pitch, fov}, framing});
  };
  for (const double azimuth : azimuths)
    add(azimuth, random.uniform(-8, 15) * kDegree, Framing::normal);
  std::vector<std::pair<double, Vec3d>> seen;
  for (const Subject& each : subjects)
    if (const auto way = direction_to(world, eye, each))
      seen.emplace_back((each.position - eye).length(), *way);
  std::sort(seen.begin(), seen.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  if (!seen.empty()) {
    const auto& [distance, way] =
        seen[random.below(static_cast<uint32_t>(std::min<size_t>(3, seen.size())))];
    // The subject is next to the middle of the picture.
    const double off = (random.uniform() < 0.5 ? 9 : -9) * kDegree;
    add(maths::atan2(way.z, way.x) + off,
        std::clamp(maths::atan2(way.y, std::sqrt(way.x * way.x + way.z * way.z)), -12 * kDegree,
                   15 * kDegree),
        distance < 4 ? Framing::close : Framing::normal);
  }
  if (stand.headroom > 4.5 && stand.headroom < kHorizon)
    add(azimuths[0], random.uniform(24, 34) * kDegree, Framing::up);
  return out;
}

}  // namespace

GateLimits limits_of(Framing framing) {
  GateLimits limits;
  if (framing == Framing::up) limits.least_floor = 0, limits.near_share = 0.1;
  if (framing == Framing::close) limits.near_share = 0.4, limits.nearest = 0.5;
  if (framing == Framing::low) limits.most_floor = 0.5, limits.nearest = 0.5;
  return limits;
}

std::vector<Candidate> candidates(const render::PreparedScene& world,
                                  const std::vector<Stand>& floor,
                                  const std::vector<Subject>& subjects, RandomKey key,
                                  size_t places) {
  const std::vector<Stand> stands = spread(floor, key.at("places"), places);
  std::vector<std::vector<Candidate>> found(stands.size());
  parallel_for(stands.size(), [&](size_t i) {
    found[i] = candidates_at(world, stands[i], subjects, key.at("poses").at(i));
  });
  std::vector<Candidate> all;
  for (const auto& each : found) all.insert(all.end(), each.begin(), each.end());
  return all;
}

}  // namespace vug::scout
