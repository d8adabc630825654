// Values that are no distances are repaired to first order, d = v / |grad v| (taubin1994,
// section 3): the zero set stays, and near it d is the distance up to O(d^2 curvature).
#include <vug/volume/block.h>

#include <algorithm>

namespace vug::volume {

using field::Dual;
using field::Exactness;
using field::Pack;
using field::PackMask;
using field::Point;

namespace {

constexpr int kPacks = Block::kSize / Pack::kLanes;  // one for each run along z
constexpr int kChunk = 16;  // packs whose points and derivatives stay in the nearest cache

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

bool any_within(Pack value, Pack limit) { return any(abs(value) < limit); }

/// Repairs those packs that reach into the band. Where the slope vanishes the quotient says
/// nothing: voxels that may neighbour a change of sign (|v| <= lipschitz * voxel) then keep a
/// value just inside the band, so that no surface passes between inactive voxels.
void repair(const field::Field& field, const Band& band, const Point<Pack>* points, Pack* values,
            field::Scratch& scratch) {
  const Pack limit(reach(band, field));
  const Pack near(1.0001 * field.lipschitz() * band.voxel);
  const Pack inside_band(std::nextafter(band.background, 0.0f));
  const Pack least(1e-12 * field.lipschitz() * field.lipschitz());
  const auto repair_some = [&](const int* which, int count) {
    field::Scratch::Frame frame(scratch);
    auto* some = frame.take<Point<Pack>>(kChunk);
    auto* slopes = frame.take<Dual<Pack>>(kChunk);
    for (int i = 0; i < count; ++i) some[i] = points[which[i]];
    field.gradients(some, count, slopes, scratch);
    for (int i = 0; i < count; ++i) {
      const Dual<Pack>& s = slopes[i];
      Pack& value = values[which[i]];
      const Pack squared = s.dx * s.dx + s.dy * s.dy + s.dz * s.dz;
      const Pack distance = value / sqrt(max(squared, least));
      const PackMask close = abs(value) <= near;
      value = select(close, min(max(distance, -inside_band), inside_band), distance);
    }
  };
  int which[kChunk];
  int count = 0;
  for (int i = 0; i < kPacks; ++i) {
    if (any_within(values[i], limit)) which[count++] = i;
    if (count == kChunk || (count > 0 && i + 1 == kPacks)) {
      repair_some(which, count);
      count = 0;
    }
  }
}

/// Unrepaired steep values keep the voxels next to a change of sign active in the same way.
void keep_neighbours(const field::Field& field, const Band& band, Pack* values) {
  const Pack near(1.0001 * field.lipschitz() * band.voxel);
  const Pack inside_band(std::nextafter(band.background, 0.0f));
  for (int i = 0; i < kPacks; ++i)
    values[i] =
        select(abs(values[i]) <= near, min(max(values[i], -inside_band), inside_band), values[i]);
}

}  // namespace

bool Block::any_active() const {
  return std::any_of(active, active + 8, [](uint64_t word) { return word != 0; });
}

void evaluate(const field::Field& field, const Cell& cell, const Band& band,
              field::Scratch& scratch, Block& block) {
  field::Scratch::Frame frame(scratch);
  auto* points = frame.take<Point<Pack>>(kPacks);
  auto* values = frame.take<Pack>(kPacks);
  place_points(cell, band.voxel, points);
  field.values(points, kPacks, values, scratch);
  if (field.exactness() > Exactness::eikonal) {
    if (band.repair)
      repair(field, band, points, values, scratch);
    else
      keep_neighbours(field, band, values);
  }
  const Pack background(band.background), zero(0.0);
  for (int x = 0; x < 8; ++x) {
    uint64_t word = 0;
    for (int y = 0; y < 8; ++y) {
      const int i = 8 * x + y;
      const PackMask active = abs(values[i]) < background;
      word |= static_cast<uint64_t>(_mm256_movemask_ps(active.bits)) << (8 * y);
      const Pack off = select(values[i] < zero, -background, background);
      select(active, values[i], off).store(block.values + 8 * i);
    }
    block.active[x] = word;
  }
}

}  // namespace vug::volume
