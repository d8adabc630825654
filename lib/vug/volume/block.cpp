// SPDX-License-Identifier: Apache-2.0
// Values that are not distances are repaired to first order, d = v / |grad v| (taubin1994, section
// 3): the zero set is unchanged, and near it d is the distance up to O(d^2 curvature).
#include <vug/field/near_surface.h>
#include <vug/volume/block.h>
#include <vug/volume/contact.h>

#include <algorithm>
#include <cmath>
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

/// The packs of a block form rows of eight along x and along y. These three of every row are
/// evaluated first: all others are at most one lattice step away from one of them, along either
/// axis.
constexpr int kFirst[] = {1, 4, 6};
constexpr int kNearestFirst[8] = {1, 1, 1, 4, 4, 4, 6, 6};

bool is_first(int pack) {
  return kNearestFirst[pack / 8] == pack / 8 && kNearestFirst[pack % 8] == pack % 8;
}

/// Lower bounds of |value| at the packs of a block, lane by lane, from values at other packs and
/// the field's maximum slope.
class LowerBounds {
 public:
  /// `bounds` has room for kPacks packs.
  LowerBounds(const field::Field& field, double voxel, Pack* bounds) : bounds_(bounds) {
    const double slope = 1.0001 * field.lipschitz() * voxel;
    for (int x = 0; x <= kSteps; ++x)
      for (int y = 0; y <= kSteps; ++y)
        change_[x][y] = Pack(slope * std::sqrt(static_cast<double>(x * x + y * y)));
    std::fill(bounds_, bounds_ + kPacks, Pack(0.0));
  }
  /// A value of the first packs bounds the others up to kSteps rows away.
  void add_first(int pack, const Pack& value) {
    const int row = pack / 8, column = pack % 8;
    const Pack magnitude = abs(value);
    for (int x = std::max(row - kSteps, 0); x <= std::min(row + kSteps, 7); ++x)
      for (int y = std::max(column - kSteps, 0); y <= std::min(column + kSteps, 7); ++y)
        raise(x, y, magnitude - change_[std::abs(x - row)][std::abs(y - column)]);
  }
  /// The others are evaluated in ascending order; a value bounds the next ones.
  void add(int pack, const Pack& value) {
    const int row = pack / 8, column = pack % 8;
    const Pack straight = abs(value) - change_[0][1], diagonal = abs(value) - change_[1][1];
    if (column < 7) raise(row, column + 1, straight);
    if (row == 7) return;
    raise(row + 1, column, straight);
    if (column > 0) raise(row + 1, column - 1, diagonal);
    if (column < 7) raise(row + 1, column + 1, diagonal);
  }
  const Pack& operator[](int pack) const { return bounds_[pack]; }

 private:
  static constexpr int kSteps = 2;
  void raise(int x, int y, const Pack& bound) {
    Pack& known = bounds_[8 * x + y];
    known = max(bound, known);  // `known` where the bound is NaN.
  }

  Pack* bounds_;
  Pack change_[kSteps + 1][kSteps + 1];
};

/// First-order distances where they reach into the band. Where the slope vanishes the quotient is
/// meaningless, and only `Neighbours` keeps the voxel in the band. Packs that cannot reach into the
/// band get a value beyond it with their sign instead.
class FirstOrderDistances {
 public:
  FirstOrderDistances(const field::Field& field, const NarrowBand& band, const Point<Pack>* points,
                      field::Scratch& scratch)
      : field_(field),
        points_(points),
        scratch_(scratch),
        frame_(scratch),
        some_(frame_.take<Point<Pack>>(kChunk)),
        slopes_(frame_.take<Dual<Pack>>(kChunk)),
        neighbours_(field, band),
        bounds_(field, band.voxel, frame_.take<Pack>(kPacks)),
        limit_(reach(band, field)),
        least_(1e-12 * field.lipschitz() * field.lipschitz()) {}

  void run(Pack* values) {
    int chunk[kChunk], count = 0;
    for (const int x : kFirst)
      for (const int y : kFirst) chunk[count++] = 8 * x + y;
    evaluate(chunk, count, values);
    for (int i = 0; i < count; ++i) bounds_.add_first(chunk[i], slopes_[i].v);
    count = 0;
    const auto evaluate_rest = [&] {
      evaluate(chunk, count, values);
      for (int i = 0; i < count; ++i) bounds_.add(chunk[i], slopes_[i].v);
      count = 0;
    };
    for (int pack = 0; pack < kPacks; ++pack) {
      if (is_first(pack)) continue;
      if (any(bounds_[pack] < limit_)) {
        chunk[count++] = pack;
        if (count == kChunk) evaluate_rest();
      } else {
        const Pack& near = values[8 * kNearestFirst[pack / 8] + kNearestFirst[pack % 8]];
        values[pack] = select(near < Pack(0.0), -Pack(kFar), Pack(kFar));
      }
    }
    evaluate_rest();
  }

 private:
  void evaluate(const int* chunk, int count, Pack* values) {
    for (int i = 0; i < count; ++i) some_[i] = points_[chunk[i]];
    if (count > 0) field_.gradients(some_, count, slopes_, scratch_);
    for (int i = 0; i < count; ++i) {
      const field::FirstOrder at = field::first_order_of(slopes_[i], least_);
      values[chunk[i]] = neighbours_.held(at.value, at.distance);
    }
  }

  const field::Field& field_;
  const Point<Pack>* points_;
  field::Scratch& scratch_;
  field::Scratch::Frame frame_;
  Point<Pack>* some_;
  Dual<Pack>* slopes_;
  Neighbours neighbours_;
  LowerBounds bounds_;
  Pack limit_, least_;
};

/// The values of a node that computes them itself near its surface, or first-order distances where
/// values are not distances, if the block is near the band.
field::BlockRange evaluate_near(const field::NearSurface& node, const field::Field& field,
                                const Cell& cell, const NarrowBand& band, Pack* values,
                                field::Scratch& scratch) {
  field::Scratch::Frame frame(scratch);
  auto* distances = frame.take<Pack>(kPacks);
  field::LatticeBlock block{.step = band.voxel};
  for (int axis = 0; axis < 3; ++axis)
    block.origin[axis] = static_cast<double>(cell.origin[axis]) * band.voxel;
  const field::BlockRange range =
      node.first_order(block, reach(band, field), {values, distances}, scratch);
  if (range != field::BlockRange::near || field.exactness() <= Exactness::eikonal) return range;
  const Neighbours neighbours(field, band);
  for (int i = 0; i < kPacks; ++i) values[i] = neighbours.held(values[i], distances[i]);
  return range;
}

/// For unrepaired steep values.
void keep_neighbours(const field::Field& field, const NarrowBand& band, Pack* values) {
  const Neighbours neighbours(field, band);
  for (int i = 0; i < kPacks; ++i) values[i] = neighbours.held(values[i], values[i]);
}

}  // namespace

const field::NearSurface* near_surface_of(const field::Field& field, const NarrowBand& band) {
  const bool distances = band.repair || field.exactness() <= Exactness::eikonal;
  return distances ? dynamic_cast<const field::NearSurface*>(field.node().get()) : nullptr;
}

void Block::fill(float value) {
  std::fill_n(values, kSize, value);
  std::fill_n(active, 8, 0);
}

bool Block::any_active() const {
  return std::any_of(active, active + 8, [](uint64_t word) { return word != 0; });
}

void evaluate(const field::Field& field, const Cell& cell, const NarrowBand& band,
              field::Scratch& scratch, Block& block) {
  field::Scratch::Frame frame(scratch);
  auto* values = frame.take<Pack>(kPacks);
  if (const field::NearSurface* near = near_surface_of(field, band)) {
    const field::BlockRange range = evaluate_near(*near, field, cell, band, values, scratch);
    if (range != field::BlockRange::near)
      return block.fill(range == field::BlockRange::above ? band.background : -band.background);
  } else {
    auto* points = frame.take<Point<Pack>>(kPacks);
    place_points(cell, band.voxel, points);
    const bool steep = field.exactness() > Exactness::eikonal;
    if (steep && band.repair) {
      FirstOrderDistances(field, band, points, scratch).run(values);
    } else {
      field.values(points, kPacks, values, scratch);
      if (steep) keep_neighbours(field, band, values);
    }
  }
  const Pack background(band.background), zero(0.0);
  const Pack contact(band.contact), zero_inside(-kLeastDistance);
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
