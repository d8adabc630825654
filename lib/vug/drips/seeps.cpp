// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/base/rng.h>
#include <vug/drips/seeps.h>
#include <vug/drips/surface.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::drips {
namespace {

/// The share of the water that reaches roofs along planes, and its mean distance from them.
constexpr double kOnPlanes = 0.85, kTraceWidth = 0.075;
/// Farther planes do not attract water. On the way, roofs are searched up and down by the second
/// number of metres.
constexpr double kPlaneReach = 3, kRoofReach = 1.5;
/// Roofs face down by this cosine: water also seeps out of steep ones, and runs down walls.
constexpr double kSeepingRoof = 0.25;
/// Gaps between roof and floor that are lower are cracks.
constexpr double kLowestGap = 0.1;
/// Most ages are a sixth of the oldest.
constexpr double kMedianAge = 1.0 / 6, kAgeSpread = 0.75;
constexpr double kLeastInterval = 2, kMostInterval = 3e5;  // Seconds between drops.
/// A vertical line crosses fewer roofs.
constexpr int64_t kRoofs = 16;

class Search {
 public:
  Search(const field::Field& rock, const SeepOptions& o)
      : rock_(rock),
        o_(o),
        wide_(static_cast<uint64_t>(std::ceil((o.to.x - o.from.x) / o.spacing))),
        deep_(static_cast<uint64_t>(std::ceil((o.to.z - o.from.z) / o.spacing))),
        key_(RandomKey(o.seed).at("drips")) {}

  uint64_t columns() const { return wide_ * deep_; }

  std::vector<Seep> in_column(uint64_t column) const {
    const uint64_t i = column % wide_, k = column / wide_;
    RandomStream random(key_.at(i).at(k));
    // One random number per statement: the order in which arguments are evaluated is unspecified.
    const double z = o_.from.z + o_.spacing * (static_cast<double>(k) + random.uniform());
    const double x = o_.from.x + o_.spacing * (static_cast<double>(i) + random.uniform());
    std::vector<Seep> seeps;
    if (x > o_.to.x || z > o_.to.z) return seeps;
    const double clustered = cluster(x, z);
    const VerticalLine line(rock_, {x, 0, z}, step());
    std::optional<double> y = o_.to.y;
    if (!line.solid(*y)) y = line.crossing(*y, o_.from.y);
    for (int64_t roof = 0; y && roof < kRoofs; ++roof) {
      const auto top = line.crossing(*y, o_.from.y);
      if (!top) break;
      const auto bottom = line.crossing(*top - 1e-6, o_.from.y);
      if (!bottom) break;
      const int64_t id = static_cast<int64_t>(column) * kRoofs + roof;
      if (*top - *bottom > kLowestGap)
        if (const auto seep = at_roof(id, {x, *top, z}, clustered)) seeps.push_back(*seep);
      y = *bottom - 1e-6;
    }
    return seeps;
  }

 private:
  double step() const { return std::min(0.25 * o_.spacing, 0.1); }

  /// The density of drips relative to the mean, from normal distributions around points that are
  /// four spacings apart; few of these give much water.
  double cluster(double x, double z) const {
    const double pitch = 4 * o_.spacing;
    const auto i = static_cast<int64_t>(std::floor(x / pitch)),
               k = static_cast<int64_t>(std::floor(z / pitch));
    double most = 0;
    for (int64_t u = i - 1; u <= i + 1; ++u)
      for (int64_t v = k - 1; v <= k + 1; ++v) {
        RandomStream random(
            key_.at("cluster").at(static_cast<uint64_t>(u)).at(static_cast<uint64_t>(v)));
        const double cx = pitch * (static_cast<double>(u) + random.uniform());
        const double cz = pitch * (static_cast<double>(v) + random.uniform());
        const double square =
            ((x - cx) * (x - cx) + (z - cz) * (z - cz)) / (o_.spacing * o_.spacing);
        const double strength = random.uniform();
        most = std::max(most, 3 * strength * strength * maths::exp(-square / (2 * 1.44)));
      }
    return 0.15 + 1.5 * most;
  }

  double chance(const Vec3d& p) const {
    double mask = 1;
    if (o_.where) mask = std::clamp(1 + o_.where->field.value(p), 0.0, 2.0);
    return o_.density * mask;
  }

  std::optional<Seep> at_roof(int64_t id, const Vec3d& roof, double clustered) const {
    RandomStream random(key_.at("roof").at(static_cast<uint64_t>(id)));
    const double rank = random.uniform(), through_plane = random.uniform();
    const double across = random.uniform();
    const double side = random.uniform() < 0.5 ? -1 : 1;
    const double interval_deviate = random.normal(), age_deviate = random.normal();
    // A density of all or nothing ignores clusters.
    const double density = chance(roof);
    if (!(rank < (density < 1 ? density * clustered : 1))) return std::nullopt;
    Seep seep;
    seep.id = id;
    seep.position = roof;
    if (o_.planes && through_plane < kOnPlanes)
      move_onto_plane(seep, side * -kTraceWidth * maths::log(1 - across));
    seep.normal = normal_at(rock_, seep.position);
    if (!(seep.normal.y < -kSeepingRoof)) return std::nullopt;
    seep.interval = std::clamp(o_.interval * maths::exp(o_.spread * interval_deviate),
                               kLeastInterval, kMostInterval);
    seep.age = o_.oldest * std::min(1.0, kMedianAge * maths::exp(kAgeSpread * age_deviate));
    return seep;
  }

  /// Moves a seep along the roof to a distance from the nearest plane; leaves it if the roof has no
  /// trace of the plane.
  void move_onto_plane(Seep& seep, double target) const {
    const auto wanted = o_.planes->nearest(seep.position);
    if (!wanted || std::fabs(wanted->distance) > kPlaneReach) return;
    Vec3d p = seep.position;
    for (int i = 0; i < 6; ++i) {
      const double distance = wanted->distance + (p - seep.position).dot(wanted->normal) - target;
      if (std::fabs(distance) < 0.02) {
        seep.position = p;
        seep.plane = wanted;
        return;
      }
      const Vec3d n = normal_at(rock_, p);
      const Vec3d along = wanted->normal - n * n.dot(wanted->normal);
      if (!(along.length2() > 0.05)) return;
      const Vec3d moved = p - along * (distance / along.length2());
      const auto height = roof_height(moved);
      if (!height || (moved - seep.position).length() > 2 * kPlaneReach) return;
      p = Vec3d(moved.x, *height, moved.z);
      if (p.x < o_.from.x || p.z < o_.from.z || p.x > o_.to.x || p.z > o_.to.z) return;
    }
  }

  /// The height of the roof nearest to a point above or below it.
  std::optional<double> roof_height(const Vec3d& p) const {
    const VerticalLine line(rock_, p, std::min(step(), 0.05));
    const bool solid = line.solid(p.y);
    return line.crossing(p.y, solid ? p.y - kRoofReach : p.y + kRoofReach);
  }

  const field::Field& rock_;
  const SeepOptions& o_;
  uint64_t wide_, deep_;
  RandomKey key_;
};

}  // namespace

void require_valid(const SeepOptions& o) {
  const Vec3d size = o.to - o.from;
  const auto fail = [](const std::string& message, const std::string& hint) {
    throw Error(ErrorCode::bad_input, message, {}, hint);
  };
  if (!(size.x > 0 && size.y > 0 && size.z > 0) || !is_finite(Box3d(o.from, o.to)))
    fail("the box in which drips are searched is empty or not finite",
         "'from' must be less than 'to' in x, y and z");
  if (!(o.spacing > 0 && o.density >= 0 && o.density <= 1))
    fail("the spacing of drips must be positive and their density 0 to 1", "try 80cm and 50%");
  if (!(o.interval > 0 && o.interval <= 1e9 && o.spread >= 0 && o.spread <= 5))
    fail(fmt::format("the interval between drops is {:g} s, but water must flow", o.interval),
         "use an interval of 1 s to 1 h; a density of 0 gives no drips");
  if (!(o.oldest > 0 && o.oldest <= 1e8))
    fail(fmt::format("the age of the oldest drips is {:g} years", o.oldest),
         "it must be positive and at most 1e8 years");
  if (!(o.last_age() >= o.oldest && o.last_age() <= 1e8))
    fail(fmt::format("the oldest drips are {:g} years old, but their final age is {:g}", o.oldest,
                     o.final_age),
         "'final_age' must be at least 'age', and at most 1e8 years");
  if (!(size.x / o.spacing * (size.z / o.spacing) <= kMostColumns))
    throw Error(ErrorCode::too_large,
                fmt::format("drips every {:g} m in a box of {:g} x {:g} m: there would be millions",
                            o.spacing, size.x, size.z),
                {}, "use a larger spacing or a smaller box");
}

double farthest_move(const SeepOptions& options) {
  return options.planes ? 2 * kPlaneReach + kRoofReach : 0;
}

std::vector<Seep> find_seeps(const field::Field& rock, const SeepOptions& options) {
  require_valid(options);
  const Search search(rock, options);
  std::vector<std::vector<Seep>> found(search.columns());
  parallel_for(found.size(), [&](size_t column) { found[column] = search.in_column(column); });
  std::vector<Seep> seeps;
  for (const auto& column : found) seeps.insert(seeps.end(), column.begin(), column.end());
  return seeps;
}

}  // namespace vug::drips
