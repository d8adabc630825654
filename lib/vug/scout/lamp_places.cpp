// SPDX-License-Identifier: Apache-2.0
// Places for lamps around a view, and the parts of the view that they light.
#include <vug/base/maths.h>
#include <vug/scout/lamps.h>
#include <vug/scout/regions.h>
#include <vug/scout/score.h>
#include <vug/scout/trace_view.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace vug::scout {
namespace {

constexpr double kFree = 0.15;  // metres from a lamp to any surface
constexpr double kAspect = static_cast<double>(kViewWidth) / kViewHeight;
constexpr double kBetweenLamps = 0.5;  // metres between lamps
constexpr size_t kMostOfRole = 6;
constexpr double kMostDistance = 8;  // metres from a key or rim to the subject

/// The mean position of the pixels of a part, moved to the nearest of them.
std::optional<Vec3d> middle_of(const View& view, const std::vector<Part>& parts, Part part) {
  Vec3d sum(0.0);
  double count = 0;
  for (size_t i = 0; i < parts.size(); ++i)
    if (parts[i] == part && view.pixels[i].object != kSky)
      sum += Vec3d(view.pixels[i].origin), ++count;
  if (count == 0) return std::nullopt;
  const Vec3d mean = sum / count;
  Vec3d best = mean;
  double nearest = kInfinity;
  for (size_t i = 0; i < parts.size(); ++i) {
    if (parts[i] != part || view.pixels[i].object == kSky) continue;
    const double away = (Vec3d(view.pixels[i].origin) - mean).length();
    if (away < nearest) nearest = away, best = Vec3d(view.pixels[i].origin);
  }
  return best;
}

/// `v` turned by an angle about the vertical axis.
Vec3d turned(const Vec3d& v, double angle) {
  const double c = maths::cos(angle), s = maths::sin(angle);
  return {c * v.x - s * v.z, v.y, s * v.x + c * v.z};
}

Vec3d level(Vec3d v) {
  v.y = 0;
  return v.length() > 1e-6 ? v.normalized() : Vec3d(1, 0, 0);
}

class Places {
 public:
  Places(const Location& location, const render::Camera& camera)
      : world_(*location.world), camera_(camera), eye_(camera.position()) {}

  bool sees(const Vec3d& from, const Vec3d& to) const {
    const Vec3d way = to - from;
    return static_cast<double>(look_along(world_, from, way).distance) > way.length() - 0.3;
  }

  /// Whether the lamp would appear in the picture.
  bool is_seen(const Vec3d& at) const {
    const auto film = camera_.project(Vec3f(at), static_cast<float>(kAspect));
    if (!film || film->x < 0 || film->x > 1 || film->y < 0 || film->y > 1) return false;
    const Vec3d way = at - eye_;
    return static_cast<double>(look_along(world_, eye_, way).distance) > way.length();
  }

  void add(LampRole role, const Vec3d& at, const Vec3d& towards) {
    size_t known = 0;
    for (const Lamp& each : lamps) {
      if ((each.at - at).length() < kBetweenLamps) return;
      if (each.role == role) ++known;
    }
    if (known >= kMostOfRole) return;
    if (clearance(world_, at) <= kFree || is_seen(at)) return;
    if ((role == LampRole::key || role == LampRole::rim) && !sees(at, towards)) return;
    lamps.push_back({role, at, towards, 1000});
  }

  /// Keys and rims around a subject.
  void add_around(const Vec3d& subject) {
    const double distance = std::min((subject - eye_).length(), kMostDistance);
    const Vec3d back = level(eye_ - subject);
    for (const double side : {1.0, -1.0}) {
      for (const auto& [azimuth, height, ratio] :
           {std::tuple(40.0, 30.0, 0.9), {55.0, 45.0, 0.7}, {60.0, 25.0, 0.5}})
        add(LampRole::key,
            around(subject, turned(back, side * azimuth * kDegree), height, ratio * distance),
            subject);
      for (const auto& [azimuth, ratio] : {std::pair(130.0, 0.4), {155.0, 0.6}})
        add(LampRole::rim,
            around(subject, turned(back, side * azimuth * kDegree), 25, ratio * distance), subject);
    }
  }

  /// Glows beyond the deepest part and to its sides.
  void add_beyond(const Vec3d& deepest) {
    const Vec3d ahead = level(deepest - eye_), side(-ahead.z, 0, ahead.x);
    for (const double along : {2.0, -0.7, -2.5})
      for (const double across : {0.0, 2.0, -2.0})
        for (const double up : {0.4, 1.5})
          add(LampRole::glow, deepest + ahead * along + side * across + Vec3d(0, up, 0), eye_);
  }

  /// Lanterns on the floor in front of the eye.
  void add_lanterns() {
    const render::Ray axis = camera_.ray({0.5f, 0.5f}, static_cast<float>(kAspect), {0.5f, 0.5f});
    const Vec3d ahead = level(Vec3d(axis.direction)), side(-ahead.z, 0, ahead.x);
    for (const double along : {2.0, 4.0, 7.0, 11.0})
      for (const double across : {-0.45, 0.45}) {
        const Vec3d above = eye_ + ahead * along + side * (across * along);
        if (!sees(eye_, above)) {
          // Behind an edge: only where the rock in between is thin.
          if (clearance(world_, above) <= kFree) continue;
        }
        if (const auto floor = floor_below(world_, above, 4))
          add(LampRole::lantern, *floor + Vec3d(0, 0.6, 0), eye_);
      }
  }

  /// Panels next to the photographer, outside the picture, for passages without room elsewhere.
  void add_at_sides(const Vec3d& subject) {
    const Vec3d ahead = level(subject - eye_), side(-ahead.z, 0, ahead.x);
    for (const double across : {2.5, -2.5, 1.2, -1.2})
      add(LampRole::key, eye_ + side * across + Vec3d(0, 0.5, 0) + ahead * 0.3, subject);
  }

  /// Places from which visible surfaces are seen, behind an edge or outside the picture.
  void add_around_corners(const View& view, const std::vector<Part>& parts, RandomKey key) {
    constexpr uint64_t kTrials = 160;
    for (uint64_t i = 0; i < kTrials; ++i) {
      RandomStream random(key.at(i));
      const size_t pixel = random.below(static_cast<uint32_t>(parts.size()));
      const Seen& seen = view.pixels[pixel];
      if (parts[pixel] == Part::none || parts[pixel] == Part::foreground) continue;
      const Vec3d normal(seen.normal), from(seen.origin);
      Vec3d way(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      if (!(way.length() > 0.1)) continue;
      way = (way.normalized() + normal).normalized();
      const double free = static_cast<double>(look_along(world_, from, way).distance);
      const Vec3d at = from + way * (random.uniform(0.3, 0.85) * std::min(free, 6.0));
      const bool beyond = parts[pixel] == Part::deepest;
      const bool behind = (at - eye_).length() > (from - eye_).length();
      add(beyond ? LampRole::glow : behind ? LampRole::rim : LampRole::key, at, from);
    }
  }

  std::vector<Lamp> lamps;

 private:
  static Vec3d around(const Vec3d& subject, const Vec3d& side, double height, double distance) {
    const double up = height * kDegree;
    return subject + side * (distance * maths::cos(up)) + Vec3d(0, distance * maths::sin(up), 0);
  }

  const render::PreparedScene& world_;
  const render::Camera& camera_;
  Vec3d eye_;
};

}  // namespace

std::vector<Part> parts_of(const View& view, const Landmarks& landmarks) {
  std::vector<double> l;
  for (const Seen& each : view.pixels)
    if (each.object != kSky)
      l.push_back(maths::log(std::max(0.01, static_cast<double>(each.distance))));
  const OtsuClasses classes = otsu_classes(l);
  std::map<uint32_t, size_t> visible;
  for (const Seen& each : view.pixels)
    if (each.object != kSky && landmarks.weights.count(each.object)) ++visible[each.object];
  uint32_t subject = kSky;
  size_t most = view.pixels.size() / 200;
  for (const auto& [object, pixels] : visible)
    if (pixels > most) most = pixels, subject = object;
  std::vector<Part> parts(view.pixels.size(), Part::none);
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) {
      const Seen& each = view.at(x, y);
      if (each.object == kSky) continue;
      const double value = maths::log(std::max(0.01, static_cast<double>(each.distance)));
      const double u = (x + 0.5) / view.width - 0.5, v = (y + 0.5) / view.height - 0.5;
      const bool is_subject =
          subject != kSky ? each.object == subject
                          : value >= classes.low && value < classes.high && u * u + v * v < 0.06;
      parts[view.index(x, y)] = is_subject              ? Part::subject
                                : value < classes.low   ? Part::foreground
                                : value >= classes.high ? Part::deepest
                                                        : Part::walls;
    }
  return parts;
}

std::vector<Lamp> lamp_places(const Location& location, const render::Camera& camera,
                              const View& view, const Landmarks& landmarks, RandomKey key) {
  const std::vector<Part> parts = parts_of(view, landmarks);
  Places places(location, camera);
  if (const auto deepest = middle_of(view, parts, Part::deepest)) places.add_beyond(*deepest);
  for (const Part part : {Part::subject, Part::walls})
    if (const auto subject = middle_of(view, parts, part)) places.add_around(*subject);
  places.add_around_corners(view, parts, key);
  places.add_lanterns();
  for (const Part part : {Part::subject, Part::walls, Part::deepest})
    if (const auto subject = middle_of(view, parts, part)) places.add_at_sides(*subject);
  return places.lamps;
}

}  // namespace vug::scout
