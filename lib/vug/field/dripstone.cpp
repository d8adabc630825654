// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/base/rng.h>
#include <vug/field/boolean.h>
#include <vug/field/dripstone.h>
#include <vug/field/registry.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

/// A roof or floor must face down or up by at least this cosine; drips run off steeper rock.
constexpr double kFacing = 0.45;
/// Lower gaps, in multiples of the tip radius, have no dripstone.
constexpr double kLowest = 6;
/// Maximum foot of a stalagmite relative to the gap, and minimum height relative to the foot.
constexpr double kMaxFoot = 0.2, kMinAspect = 1.5;
/// Minimum radius of stalagmites (curl1973: 3 cm in diameter and more).
constexpr double kThinnestStalagmite = 0.015;

/// Intersections of the vertical line through `at` with the surface of the rock, from top to
/// bottom. Heights are sampled at fixed steps; samples whose sign follows from the Lipschitz
/// constant and an earlier value are not evaluated.
class VerticalLine {
 public:
  VerticalLine(const Field& rock, const Vec3d& at, double step)
      : rock_(rock), at_(at), step_(step) {}

  /// The height of the first change of sign below `high`; nothing if it does not occur above `low`.
  std::optional<double> crossing(double high, double low) const {
    const double first = value(rock_, high);
    const bool inside = first <= 0;
    for (double y = high, known = high - clearance(first); y > low;) {
      const double next = std::max(y - step_, low);
      if (next <= known) {
        const double there = value(rock_, next);
        if ((there <= 0) != inside) return refined(y, next, inside);
        known = next - clearance(there);
      }
      y = next;
    }
    return std::nullopt;
  }
  bool solid(double y) const { return value(rock_, y) <= 0; }

 private:
  double value(const Field& rock, double y) const { return rock.value({at_.x, y, at_.z}); }
  /// A distance within which the sign cannot differ from that of the value, less a margin for
  /// rounding.
  double clearance(double value) const {
    const double size = std::fabs(value);
    return size > 1e-6 ? (size - 1e-6) / rock_.lipschitz() * (1 - 1e-6) : 0;
  }
  double refined(double high, double low, bool inside) const {
    const Ball ball{{at_.x, 0.5 * (high + low), at_.z}, 0.5 * (high - low) * (1 + 1e-9) + 1e-9};
    const Field local = rock_.restricted(ball).field;
    for (int i = 0; i < 24; ++i) {
      const double middle = 0.5 * (high + low);
      ((value(local, middle) <= 0) == inside ? high : low) = middle;
    }
    return 0.5 * (high + low);
  }
  const Field& rock_;
  Vec3d at_;
  double step_;
};

/// The vertical component of the surface normal at p: 1 for floors, -1 for roofs.
double facing(const Field& rock, const Vec3d& p) {
  const Vec3d slope = rock.gradient(p).gradient;
  const double steep = slope.length();
  return steep > 0 ? slope.y / steep : 0;
}

/// Few grow long: the cube of a uniform random number, because most drips are young or dried up.
Drip grown_drip(const Vec3d& roof, const Vec3d& floor, double vigour, const DripOptions& o,
                RandomStream& random) {
  Drip drip{roof, floor, 0, 0, false};
  const double gap = roof.y - floor.y;
  const double age = random.uniform();
  drip.stalactite = o.length * vigour * (0.1 + 0.9 * age * age * age);
  if (random.uniform() < o.stalagmites)
    drip.stalagmite = drip.stalactite * random.uniform(0.35, 0.85);
  drip.column = drip.stalagmite > 0 && drip.stalactite + drip.stalagmite > 0.8 * gap;
  drip.stalactite = std::min(drip.stalactite, 0.7 * gap);
  drip.stalagmite = std::min(drip.stalagmite, 0.6 * gap);
  return drip;
}

std::vector<Drip> drips_at(const Field& rock, const Vec3d& at, double vigour, const DripOptions& o,
                           RandomStream& random) {
  std::vector<Drip> drips;
  const VerticalLine line(rock, at, std::min(0.25 * o.spacing, 0.1));
  std::optional<double> y = o.to.y;
  if (!line.solid(*y)) y = line.crossing(*y, o.from.y);
  while (y) {
    const auto roof_y = line.crossing(*y, o.from.y);
    if (!roof_y) break;
    const auto floor_y = line.crossing(*roof_y - 1e-6, o.from.y);
    if (!floor_y) break;
    const Vec3d roof(at.x, *roof_y, at.z), floor(at.x, *floor_y, at.z);
    if (roof.y - floor.y > kLowest * o.tip && facing(rock, roof) < -kFacing) {
      Drip drip = grown_drip(roof, floor, vigour, o, random);
      if (facing(rock, floor) < kFacing) {
        drip.stalagmite = 0;
        drip.column = false;
      }
      drips.push_back(drip);
    }
    y = *floor_y - 1e-6;
  }
  return drips;
}

Field rod(const Vec3d& a, const Vec3d& b, double radius_a, double radius_b) {
  return make("tapered_capsule",
              {{"a", a}, {"b", b}, {"radius_a", radius_a}, {"radius_b", radius_b}});
}

/// A stalactite in its ideal form: the radius is proportional to the height above the tip to the
/// power 3/4 (short2005). Segments between a few heights of that curve are cones with round ends.
void add_stalactite(const Vec3d& root, double length, double thick, double tip,
                    std::vector<Field>& parts) {
  constexpr double kHeights[] = {1, 0.62, 0.3, 0};
  const auto at = [&](double h) { return root - Vec3d(0, length * (1 - h), 0); };
  const auto radius = [&](double h) { return tip + (thick - tip) * maths::pow(h, 0.75); };
  for (int i = 0; i < 3; ++i)
    parts.push_back(
        rod(at(kHeights[i]), at(kHeights[i + 1]), radius(kHeights[i]), radius(kHeights[i + 1])));
}

/// Wider at its foot, where water spreads, and blunt on top, where it splashes.
void add_stalagmite(const Vec3d& base, double foot, double top, double tip,
                    std::vector<Field>& parts) {
  const double blunt = std::max(0.35 * foot, tip), height = top - blunt - base.y;
  const Vec3d shoulder = base + Vec3d(0, 0.3 * height, 0);
  const double waist = std::max(0.62 * foot, blunt);
  parts.push_back(rod(base, shoulder, foot, waist));
  parts.push_back(rod(shoulder, base + Vec3d(0, height, 0), waist, blunt));
}

}  // namespace

std::vector<Drip> find_drips(const Field& rock, const DripOptions& o) {
  const auto wide = static_cast<size_t>(std::ceil((o.to.x - o.from.x) / o.spacing)),
             deep = static_cast<size_t>(std::ceil((o.to.z - o.from.z) / o.spacing));
  const RandomKey key = RandomKey(static_cast<uint64_t>(o.seed)).at("dripstone");
  std::vector<std::vector<Drip>> found(wide * deep);
  parallel_for(found.size(), [&](size_t cell) {
    RandomStream random(key.at(cell % wide).at(cell / wide));
    const auto place = [&](double from, size_t index) {
      return from + o.spacing * (static_cast<double>(index) + random.uniform());
    };
    const double z = place(o.from.z, cell / wide);  // One random number per statement, because the
                                                    // evaluation order of arguments is unspecified.
    const Vec3d at(place(o.from.x, cell % wide), 0, z);
    if (at.x > o.to.x || at.z > o.to.z) return;
    double chance = 0.5;
    const double middle = 0.5 * (o.from.y + o.to.y);
    if (o.where)
      chance = std::clamp(0.5 + 0.5 * o.where->field.value({at.x, middle, at.z}), 0.0, 1.0);
    if (random.uniform() < chance) found[cell] = drips_at(rock, at, std::sqrt(chance), o, random);
  });
  std::vector<Drip> drips;
  for (const auto& cell : found) drips.insert(drips.end(), cell.begin(), cell.end());
  return drips;
}

Field dripstone(const std::vector<Drip>& drips, const DripOptions& o) {
  std::vector<Field> parts;
  for (const Drip& d : drips) {
    const double gap = d.roof.y - d.floor.y;
    const double thick = std::max(o.girth * d.stalactite, 1.2 * o.tip);
    const double foot = std::min(
        std::max({1.5 * o.girth * d.stalagmite, 1.5 * o.tip, kThinnestStalagmite}), kMaxFoot * gap);
    // Roots start inside the rock, so that none is detached on a sloping roof.
    const Vec3d root = d.roof + Vec3d(0, thick, 0), base = d.floor - Vec3d(0, 0.5 * foot, 0);
    if (d.column) {
      const Vec3d waist = d.floor + (d.roof - d.floor) * 0.45;
      const double slim = std::max(0.6 * thick, o.tip);
      parts.push_back(rod(root, waist, 1.1 * thick + o.tip, slim));
      parts.push_back(rod(base, waist, 1.2 * foot + o.tip, slim));
      continue;
    }
    add_stalactite(root, d.stalactite + thick, thick, o.tip, parts);
    if (d.stalagmite > kMinAspect * foot)
      add_stalagmite(base, foot, d.floor.y + d.stalagmite, o.tip, parts);
  }
  return unite(std::move(parts));
}

Box3d dripstone_bounds(const Box3d& rock, const DripOptions& o) {
  // Roots, feet and their radii exceed the points of roofs and floors by less than this.
  const double thick = std::max({o.girth * o.length, 1.5 * o.tip, kThinnestStalagmite});
  return grown(intersection(rock, Box3d(o.from, o.to)), 3 * thick);
}

}  // namespace vug::field
