// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/transform.h>
#include <vug/mesh/stones/stone_bed.h>

#include <algorithm>
#include <cmath>

namespace vug::mesh {
namespace {

constexpr int kSides = 32;           // Poses on a plane from which one is drawn for each stone.
constexpr int kMostSlides = 4;       // Steps down a slope.
constexpr double kSlide = 0.6;       // Length of such a step over the radius.
constexpr double kMostClimb = 1;     // Height of other stones below a stone, over its radius.
constexpr double kTolerance = 0.01;  // Of contacts, over the radius; at most a millimetre.

double tolerance(double radius) { return std::min(1e-3, kTolerance * radius); }

/// A random rotation, uniform over all.
StonePose random_pose(RandomStream& random) {
  const double y = random.uniform(-1, 1), turn = random.uniform(0, 2 * kPi);
  const double across = std::sqrt(std::max(0.0, 1 - y * y));
  const Vec3d axis(across * maths::cos(turn), y, across * maths::sin(turn));
  const Transform to = rotation_between({0, 1, 0}, axis) *
                       Transform::rotation({0, 1, 0}, random.uniform(0, 2 * kPi));
  return {Vec3d(0.0), to.column(0), to.column(1), to.column(2), 1};
}

/// The gaps of all corners above a plane at height 0.
void gaps_above_plane(const StoneShape& shape, const StonePose& pose, std::vector<Gap>& gaps) {
  for (const Vec3d& corner : shape.corners) {
    const Vec3d at = pose.offset(corner);
    gaps.push_back({at.x, at.z, pose.centre.y + at.y, 0});
  }
}

std::vector<StonePose> sides_of(const StoneShape& shape) {
  std::vector<StonePose> sides;
  const RandomKey key(0);
  for (uint64_t i = 0; i < 4 * kSides && sides.size() < kSides; ++i) {
    RandomStream random(key.at(i));
    const std::optional<Rest> rest =
        settle(random_pose(random), shape.radius, tolerance(shape.radius),
               [&](const StonePose& pose, std::vector<Gap>& gaps) {
                 gaps_above_plane(shape, pose, gaps);
               });
    if (rest) sides.push_back(rest->pose);
  }
  if (sides.empty()) sides.push_back({});
  return sides;
}

StonePose rotated(const Transform& by, StonePose pose) {
  pose.x = by.vector(pose.x), pose.y = by.vector(pose.y), pose.z = by.vector(pose.z);
  return pose;
}

uint64_t cell_number(int64_t x, int64_t z) {
  return static_cast<uint64_t>(x) << 32 ^ (static_cast<uint64_t>(z) & 0xffffffffu);
}

}  // namespace

StoneBed::StoneBed(const Mesh& ground, std::vector<StoneShape> shapes,
                   const StoneBedOptions& options)
    : ground_(ground), shapes_(std::move(shapes)), options_(options) {
  for (const StoneShape& shape : shapes_) sides_.push_back(sides_of(shape));
}

std::vector<uint32_t> StoneBed::neighbours(const Vec3d& centre, double radius) const {
  std::vector<uint32_t> found;
  const auto cell = [&](double at) { return static_cast<int64_t>(std::floor(at / options_.cell)); };
  for (int64_t x = cell(centre.x - radius); x <= cell(centre.x + radius); ++x)
    for (int64_t z = cell(centre.z - radius); z <= cell(centre.z + radius); ++z)
      if (const auto at = cells_.find(cell_number(x, z)); at != cells_.end())
        found.insert(found.end(), at->second.begin(), at->second.end());
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  found.erase(std::remove_if(found.begin(), found.end(),
                             [&](uint32_t i) {
                               const BedStone& other = stones_[i];
                               const double reach =
                                   radius + shapes_[other.shape].radius * other.rest.pose.scale;
                               return (other.rest.pose.centre - centre).length() > 2 * reach;
                             }),
              found.end());
  return found;
}

void StoneBed::enter(uint32_t stone) {
  const BedStone& entered = stones_[stone];
  const double radius = shapes_[entered.shape].radius * entered.rest.pose.scale;
  const Vec3d& centre = entered.rest.pose.centre;
  const auto cell = [&](double at) { return static_cast<int64_t>(std::floor(at / options_.cell)); };
  for (int64_t x = cell(centre.x - radius); x <= cell(centre.x + radius); ++x)
    for (int64_t z = cell(centre.z - radius); z <= cell(centre.z + radius); ++z)
      cells_[cell_number(x, z)].push_back(stone);
}

StoneBed::Outcome StoneBed::rest_at(const StoneShape& shape, const StonePose& start,
                                    const Vec3d& at, const GroundPatch& patch, Rest& rest) const {
  const double radius = shape.radius * start.scale;
  const std::vector<uint32_t> others = neighbours(start.centre, radius);
  const auto floor = [&](double x, double z) {
    double height = patch.floor(x, z);
    for (const uint32_t i : others)
      if (const auto top = heights_at(shapes_[stones_[i].shape], stones_[i].rest.pose, x, z))
        height = std::max(height, top->high);
    return height;
  };
  const double highest = at.y + kMostClimb * radius;
  if (floor(at.x, at.z) > highest) return Outcome::has_no_room;
  // Corners of the ground and points of other stones may touch a face of the stone.
  std::vector<Vec3d> below = patch.corners();
  for (const uint32_t i : others) {
    const BedStone& other = stones_[i];
    for (const Vec3d& probe : shapes_[other.shape].probes) {
      const Vec3d offset = other.rest.pose.offset(probe);
      if (offset.y > 0) below.push_back(other.rest.pose.centre + offset);
    }
  }
  below.erase(std::remove_if(below.begin(), below.end(),
                             [&](const Vec3d& p) {
                               const Vec3d away(p.x - start.centre.x, 0, p.z - start.centre.z);
                               return away.length2() > radius * radius;
                             }),
              below.end());
  const auto gaps = [&](const StonePose& pose, std::vector<Gap>& out) {
    for (const Vec3d& probe : shape.probes) {
      const Vec3d offset = pose.offset(probe);
      if (offset.y > 0.3 * radius) continue;  // The upper side does not touch the ground.
      const double height = floor(pose.centre.x + offset.x, pose.centre.z + offset.z);
      if (height > -kInfinity)
        out.push_back({offset.x, offset.z, pose.centre.y + offset.y - height, height});
    }
    for (const Vec3d& p : below)
      if (const auto own = heights_at(shape, pose, p.x, p.z))
        out.push_back({p.x - pose.centre.x, p.z - pose.centre.z, own->low - p.y, p.y});
  };
  const std::optional<Rest> found = settle(start, radius, tolerance(radius), gaps);
  if (!found) return Outcome::slides;
  rest = *found;
  const double height = rest.pose.centre.y;
  if (height > highest + radius || height < at.y - radius) return Outcome::has_no_room;
  const Vec3d area = rest.contact_area();
  const Vec3d up = area.length() > 0.01 * radius * radius ? area.normalized() : patch.mean_up();
  if (up.y < maths::cos(options_.repose)) return Outcome::slides;
  for (const Vec3d& corner : shape.corners) {
    const Vec3d p = rest.pose.centre + rest.pose.offset(corner);
    const double below_it = floor(p.x, p.z);
    if (p.y < below_it - tolerance(radius) || patch.roof(p.x, p.z, std::max(below_it, at.y)) < p.y)
      return Outcome::has_no_room;
  }
  return Outcome::rests;
}

bool StoneBed::add(size_t shape_number, double diameter, const Vec3d& at, RandomKey key) {
  const StoneShape& shape = shapes_[shape_number];
  RandomStream random(key);
  const std::vector<StonePose>& sides = sides_[shape_number];
  const StonePose& side = sides[random.below(static_cast<uint32_t>(sides.size()))];
  const double turn = random.uniform(0, 2 * kPi);
  const double scale = diameter / shape.diameter, radius = shape.radius * scale;
  Vec3d place = at;
  for (int slide = 0; slide <= kMostSlides; ++slide) {
    const GroundPatch patch = ground_.patch(
        {place - Vec3d(radius, 2 * radius, radius), place + Vec3d(radius, 3 * radius, radius)});
    const Vec3d up = patch.mean_up();
    StonePose start =
        rotated(rotation_between({0, 1, 0}, up) * Transform::rotation({0, 1, 0}, turn), side);
    start.scale = scale;
    start.centre = place + Vec3d(0, radius, 0);
    Rest rest;
    const Outcome outcome = rest_at(shape, start, place, patch, rest);
    if (outcome == Outcome::rests) {
      stones_.push_back({shape_number, rest});
      enter(static_cast<uint32_t>(stones_.size() - 1));
      return true;
    }
    if (outcome == Outcome::has_no_room) return false;
    const Vec3d downhill(up.x, 0, up.z);
    if (downhill.length() < 0.05) return false;
    place += downhill.normalized() * (kSlide * radius);
    place.y = patch.floor(place.x, place.z);
    if (!(place.y > -kInfinity)) return false;
  }
  return false;
}

}  // namespace vug::mesh
