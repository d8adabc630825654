// SPDX-License-Identifier: Apache-2.0
// Values that are not distances are repaired to first order, d = v / |grad v| (taubin1994, section
// 3): the zero set is unchanged, and near it d is the distance up to O(d^2 curvature).
#include <vug/volume/block.h>
#include <vug/volume/contact.h>

#include <algorithm>
#include <cstdlib>

namespace vug::volume {

using field::Dual;
using field::Exactness;
using field::Pack;
using field::PackMask;
using field::Point;

namespace {

constexpr int kPacks = Block::kSize / Pack::kLanes;  // One for each run along z.
constexpr double kFar = 1e30;
constexpr int kChunk = 16;  // Packs whose points and derivatives stay in the first-level cache.

float coordinate(int64_t index, double voxel) {
  return static_cast<float>(static_cast<double>(index) * voxel);
}

void place_points(const Cell& cell, double voxel, Point<Pack>* points) {
  float z[8];
  for (int k = 0; k < 8; ++k) z[k] = coordinate(cell.origin[2] + k, voxel);
  const Pack run = Pack::load(z);
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 8; ++y)
      points[8 * x + y] = {Pack(coordinate(cell.origin[0] + x, voxel)),
                           Pack(coordinate(cell.origin[1] + y, voxel)), run};
}

/// The packs of a block form rows of eight along x and along y. These three of every row are
/// evaluated first: all others are at most one lattice step away from one of them, along either
/// axis.
constexpr int kLooked[] = {1, 4, 6};
constexpr int kNearestLooked[8] = {0, 0, 0, 1, 1, 1, 2, 2};  // Index into kLooked.

float least_magnitude(Pack value) {
  float lanes[Pack::kLanes];
  abs(value).store(lanes);
  return *std::min_element(lanes, lanes + Pack::kLanes);
}

/// Finds the packs that may reach into the band, from nine of them and the field's maximum slope.
/// The others get a value beyond the band with their sign.
int find_in_reach(const field::Field& field, const NarrowBand& band, const Point<Pack>* points,
                  Pack* values, int* found, field::Scratch& scratch) {
  Point<Pack> looked[9];
  Pack seen[9];
  for (int i = 0; i < 9; ++i) looked[i] = points[8 * kLooked[i / 3] + kLooked[i % 3]];
  field.values(looked, 9, seen, scratch);
  const double limit = reach(band, field), slope = 1.0001 * field.lipschitz() * band.voxel;
  float away[9];
  for (int i = 0; i < 9; ++i) away[i] = least_magnitude(seen[i]);
  int count = 0;
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 8; ++y) {
      const int near = 3 * kNearestLooked[x] + kNearestLooked[y];
      const int steps = (x != kLooked[kNearestLooked[x]]) + (y != kLooked[kNearestLooked[y]]);
      constexpr double kLength[] = {0, 1, 1.41422};
      if (static_cast<double>(away[near]) < limit + slope * kLength[steps])
        found[count++] = 8 * x + y;
      else
        values[8 * x + y] = select(seen[near] < Pack(0.0), -Pack(kFar), Pack(kFar));
    }
  return count;
}

/// Voxels that may be adjacent to a change of sign (|v| <= lipschitz * voxel) keep a value inside
/// the band, so that no surface passes between inactive voxels.
class Neighbours {
 public:
  Neighbours(const field::Field& field, const NarrowBand& band)
      : near_(1.0001 * field.lipschitz() * band.voxel),
        inside_band_(std::nextafter(band.background, 0.0f)) {}
  /// The stored `distance` where the field's value is `value`.
  Pack held(Pack value, Pack distance) const {
    return select(abs(value) <= near_, min(max(distance, -inside_band_), inside_band_), distance);
  }

 private:
  Pack near_, inside_band_;
};

/// First-order distances where they reach into the band. Where the slope vanishes the quotient is
/// meaningless, and only `Neighbours` keeps the voxel in the band.
void distances(const field::Field& field, const NarrowBand& band, const Point<Pack>* points,
               Pack* values, field::Scratch& scratch) {
  int found[kPacks];
  const int count = find_in_reach(field, band, points, values, found, scratch);
  const Neighbours neighbours(field, band);
  const Pack least(1e-12 * field.lipschitz() * field.lipschitz());
  field::Scratch::Frame frame(scratch);
  auto* some = frame.take<Point<Pack>>(kChunk);
  auto* slopes = frame.take<Dual<Pack>>(kChunk);
  for (int begin = 0; begin < count; begin += kChunk) {
    const int now = std::min(kChunk, count - begin);
    for (int i = 0; i < now; ++i) some[i] = points[found[begin + i]];
    field.gradients(some, now, slopes, scratch);
    for (int i = 0; i < now; ++i) {
      const Dual<Pack>& s = slopes[i];
      const Pack squared = s.dx * s.dx + s.dy * s.dy + s.dz * s.dz;
      values[found[begin + i]] = neighbours.held(s.v, s.v / sqrt(max(squared, least)));
    }
  }
}

/// For unrepaired steep values.
void keep_neighbours(const field::Field& field, const NarrowBand& band, Pack* values) {
  const Neighbours neighbours(field, band);
  for (int i = 0; i < kPacks; ++i) values[i] = neighbours.held(values[i], values[i]);
}

float contact_in(const Cell& cell, double voxel) {
  int64_t farthest = 0;
  for (const int64_t low : cell.origin)
    farthest = std::max({farthest, std::abs(low), std::abs(low + cell.size)});
  return contact_distance(static_cast<double>(farthest) * voxel);
}

}  // namespace

bool Block::any_active() const {
  return std::any_of(active, active + 8, [](uint64_t word) { return word != 0; });
}

void evaluate(const field::Field& field, const Cell& cell, const NarrowBand& band,
              field::Scratch& scratch, Block& block) {
  field::Scratch::Frame frame(scratch);
  auto* points = frame.take<Point<Pack>>(kPacks);
  auto* values = frame.take<Pack>(kPacks);
  place_points(cell, band.voxel, points);
  const bool steep = field.exactness() > Exactness::eikonal;
  if (steep && band.repair) {
    distances(field, band, points, values, scratch);
  } else {
    field.values(points, kPacks, values, scratch);
    if (steep) keep_neighbours(field, band, values);
  }
  const Pack background(band.background), zero(0.0);
  const Pack contact(contact_in(cell, band.voxel)), zero_inside(-kLeastDistance);
  for (int x = 0; x < 8; ++x) {
    uint64_t word = 0;
    for (int y = 0; y < 8; ++y) {
      const int i = 8 * x + y;
      values[i] = select(abs(values[i]) <= contact, min(-abs(values[i]), zero_inside), values[i]);
      const PackMask active = abs(values[i]) < background;
      word |= static_cast<uint64_t>(_mm256_movemask_ps(active.bits)) << (8 * y);
      const Pack off = select(values[i] < zero, -background, background);
      select(active, values[i], off).store(block.values + 8 * i);
    }
    block.active[x] = word;
  }
}

}  // namespace vug::volume
