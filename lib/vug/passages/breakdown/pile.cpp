// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/base/rng.h>
#include <vug/passages/breakdown/box_grid.h>
#include <vug/passages/breakdown/broken_block.h>
#include <vug/passages/breakdown/pile.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

constexpr int kPlaces = 64;             // Places that are compared for each block.
constexpr int kAttitudes = 8;           // Orientations that are compared at the best place.
constexpr int kDescentSteps = 80;       // Attempts to descend from each.
constexpr double kLeastDescent = 1e-4;  // Metres; smaller descents end.

void require_pile_options(const PileOptions& o) {
  if (!(std::fabs(o.floor) <= 1e6))
    throw Error(
        ErrorCode::bad_input,
        fmt::format("invalid height {:g} m of the floor of a pile: must be -1e6 to 1e6", o.floor),
        {}, "give its height in metres");
  if (!(o.repose >= 0.1 && o.repose <= 1.2))
    throw Error(
        ErrorCode::bad_input,
        fmt::format("invalid angle of repose of {:g} radians: must be 0.1 to 1.2", o.repose), {},
        "blocks rest at 30 to 40 degrees");
  if (!(o.bulk >= 1.05 && o.bulk <= 3))
    throw Error(ErrorCode::bad_input, fmt::format("invalid bulk {:g}: must be 1.05 to 3", o.bulk),
                {}, "fallen rock takes 1.4 times its volume");
  if (!(o.broken >= 0 && o.broken <= 1))
    throw Error(ErrorCode::bad_input,
                fmt::format("invalid depth {:g} of breaks: must be 0 to 1", o.broken), {},
                "use 0 for blocks with sharp edges");
}

/// The height of a cone with a ridge of this half length that has the volume.
double height_for(double volume, double ridge, double slope) {
  double low = 0, high = maths::pow(volume * slope * slope, 1.0 / 3) + 1;
  for (int i = 0; i < 100; ++i) {
    const double h = 0.5 * (low + high);
    const double v = kPi * h * h * h / (3 * slope * slope) + 2 * ridge * h * h / slope;
    (v < volume ? low : high) = h;
  }
  return low;
}

/// Builds a pile block by block.
class Builder {
 public:
  Builder(Pile start, double floor, double largest, RandomKey key)
      : pile_(std::move(start)),
        floor_(floor),
        tops_(pile_, largest),
        grid_(largest),
        random_(key) {}

  double volume() const { return tops_.volume(); }

  /// False if the cone has no room for the block.
  bool add(OrientedBox block) {
    const std::optional<Vec3d> place = emptiest_place(block);
    if (!place) return false;
    OrientedBox best;
    double least = kInfinity;
    for (int i = 0; i < kAttitudes; ++i) {
      block.centre = *place;
      const OrientedBox rest = descend(randomly_turned(block));
      if (rest.centre.y >= least) continue;
      least = rest.centre.y;
      best = rest;
    }
    grid_.add(best);
    tops_.add(best);
    pile_.blocks.push_back(best);
    return true;
  }

  Pile finish(double broken, RandomKey key) {
    const std::vector<std::vector<Vec3d>> contacts = contact_points(pile_.blocks, floor_);
    for (size_t i = 0; i < pile_.blocks.size(); ++i)
      pile_.broken.push_back(
          broken_block(pile_.blocks[i], contacts[i], broken, RandomStream(key.at(i))));
    return std::move(pile_);
  }

 private:
  /// The place where the pile lacks most of the cone below the block.
  std::optional<Vec3d> emptiest_place(const OrientedBox& block) {
    const double radius = pile_.height / pile_.slope, reach = block.extent({0, 1, 0});
    const double footprint = 0.4 * (block.half.x + block.half.z);
    const Vec3d across = pile_.along.cross({0, 1, 0});
    std::optional<Vec3d> best;
    double most = 0;
    for (int i = 0; i < kPlaces; ++i) {
      const double x = random_.uniform(-1, 1) * (pile_.ridge + radius);
      const double z = random_.uniform(-1, 1) * radius;
      const Vec3d p = pile_.foot + pile_.along * x + across * z;
      if (pile_.cone(p) < 0.8 * reach) continue;
      const double lack = tops_.mean_lack(p, footprint);
      if (lack <= most) continue;
      most = lack;
      best = p;
    }
    return best;
  }

  /// About the vertical by any angle, after a tilt of up to about 30 degrees.
  OrientedBox randomly_turned(const OrientedBox& block) {
    const double tilt = 0.3 * random_.normal(), heading = random_.uniform(0, 2 * kPi);
    const OrientedBox tilted =
        block.turned({maths::cos(heading), 0, maths::sin(heading)}, std::clamp(tilt, -0.6, 0.6));
    return tilted.turned({0, 1, 0}, random_.uniform(0, 2 * kPi));
  }

  /// The block where it first touches the ground or another block.
  OrientedBox landed(OrientedBox block) const {
    double height = floor_ + block.extent({0, 1, 0});
    grid_.for_each_near(block, [&](const OrientedBox& other, size_t) {
      height = std::max(height, landing_height(block, other));
    });
    block.centre.y = height;
    return block;
  }

  OrientedBox descend(const OrientedBox& start) {
    OrientedBox rest = landed(start);
    const double size = 2 * std::min({rest.half.x, rest.half.y, rest.half.z});
    const Vec3d from = rest.centre;
    double step = 1;
    for (int i = 0; i < kDescentSteps; ++i) {
      OrientedBox next = rest;
      const Vec3d axis(random_.normal(), 0.3 * random_.normal(), random_.normal());
      if (axis.length() > 1e-6)
        next = rest.turned(axis.normalized(), 0.25 * step * random_.normal());
      next.centre.x += 0.3 * step * size * random_.normal();
      next.centre.z += 0.3 * step * size * random_.normal();
      const Vec3d moved = next.centre - from;
      if (Vec3d(moved.x, 0, moved.z).length() > size || pile_.cone(next.centre) < 0.4 * size)
        continue;
      next = landed(next);
      if (next.centre.y < rest.centre.y - kLeastDescent)
        rest = next;
      else
        step = std::max(0.02, 0.94 * step);
    }
    return rest;
  }

  Pile pile_;
  double floor_;
  TopMap tops_;
  BoxGrid grid_;
  RandomStream random_;
};

}  // namespace

Vec3d Pile::from_ridge(const Vec3d& p) const {
  const Vec3d offset(p.x - foot.x, 0, p.z - foot.z);
  return offset - along * std::clamp(offset.dot(along), -ridge, ridge);
}

double Pile::cone(const Vec3d& p) const { return height - slope * from_ridge(p).length(); }

double Pile::volume() const {
  double largest = 0.01;
  for (const OrientedBox& block : blocks) largest = std::max(largest, 2 * block.half.length());
  TopMap tops(*this, largest);
  for (const OrientedBox& block : blocks) tops.add(block);
  return tops.volume();
}

Pile pile_cone(const Vault& vault, const PileOptions& options) {
  require_pile_options(options);
  if (vault.blocks.empty()) return {};
  Pile out;
  out.slope = maths::tan(options.repose);
  Box3d extent;
  Vec3d middle(0.0);
  for (const OrientedBox& block : vault.blocks) middle += block.centre * block.volume();
  middle *= 1 / vault.volume();
  const std::array<Vec3d, 3>& axes = vault.blocks.front().axes;
  for (const OrientedBox& block : vault.blocks)
    for (int i = 0; i < 3; ++i) {
      const double at = axes[static_cast<size_t>(i)].dot(block.centre - middle);
      extent.min[i] = std::min(extent.min[i], at - block.half[i]);
      extent.max[i] = std::max(extent.max[i], at + block.half[i]);
    }
  const Vec3d size = extent.size();
  const Vec3d along = size.x > size.z ? axes[0] : axes[2];
  out.along = Vec3d(along.x, 0, along.z).normalized();
  out.ridge = 0.35 * std::fabs(size.x - size.z);
  out.foot = {middle.x, options.floor, middle.z};
  out.height = height_for(options.bulk * vault.volume(), out.ridge, out.slope);
  double roof = -kInfinity;
  for (const OrientedBox& block : vault.blocks) roof = std::max(roof, block.bounds().max.y);
  if (!(options.floor + out.height < roof))
    throw Error(ErrorCode::bad_input,
                fmt::format("the pile below a vault would be {:.4g} m high and reach the roof, "
                            "which is {:.4g} m above the floor",
                            out.height, roof - options.floor),
                {}, "lower the floor, or use stronger rock or a smaller span");
  return out;
}

Pile pile(const Vault& vault, const PileOptions& options) {
  Pile start = pile_cone(vault, options);
  if (vault.blocks.empty()) return start;
  const double wanted = options.bulk * vault.volume();
  Builder builder(std::move(start), options.floor, vault.largest(),
                  RandomKey(options.seed).at("pile"));
  for (const OrientedBox& block : vault.blocks) {
    if (builder.volume() >= wanted) break;
    builder.add(block);
  }
  return builder.finish(options.broken, RandomKey(options.seed).at("breaks"));
}

}  // namespace vug::passages
