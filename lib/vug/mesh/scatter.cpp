// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/mesh/scatter.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace vug::mesh {
namespace {

/// Candidates per squared spacing. This number finds nine tenths of the points that infinitely many
/// darts would find.
constexpr double kTries = 16;
constexpr double kMostTries = 1u << 26;

/// Points in cubes with the spacing as edge: neighbours within the spacing lie in 27 cubes.
class Cubes {
 public:
  explicit Cubes(double spacing) : spacing_(spacing) {}

  bool is_free(const Vec3d& p) const {
    const auto [x, y, z] = cube(p);
    for (int64_t i = x - 1; i <= x + 1; ++i)
      for (int64_t j = y - 1; j <= y + 1; ++j)
        for (int64_t k = z - 1; k <= z + 1; ++k) {
          const auto first = first_.find(number({i, j, k}));
          if (first == first_.end()) continue;
          for (uint32_t at = first->second; at != kNone; at = next_[at])
            if ((points_[at] - p).length2() < spacing_ * spacing_) return false;
        }
    return true;
  }
  void add(const Vec3d& p) {
    const auto [at, is_new] = first_.try_emplace(number(cube(p)), kNone);
    next_.push_back(at->second);
    at->second = static_cast<uint32_t>(points_.size());
    points_.push_back(p);
  }

 private:
  static constexpr uint32_t kNone = ~0u;
  using Cube = std::array<int64_t, 3>;
  Cube cube(const Vec3d& p) const {
    return {static_cast<int64_t>(std::floor(p.x / spacing_)),
            static_cast<int64_t>(std::floor(p.y / spacing_)),
            static_cast<int64_t>(std::floor(p.z / spacing_))};
  }
  /// Cubes 2^21 apart share a number, which costs time but does not affect the result.
  static uint64_t number(const Cube& c) {
    const auto low = [](int64_t i) { return static_cast<uint64_t>(i) & 0x1fffff; };
    return low(c[0]) << 42 | low(c[1]) << 21 | low(c[2]);
  }

  double spacing_;
  std::unordered_map<uint64_t, uint32_t> first_;
  std::vector<uint32_t> next_;
  std::vector<Vec3d> points_;
};

}  // namespace

std::vector<SurfaceSample> scatter(const Mesh& mesh, const ScatterOptions& options,
                                   Progress& progress) {
  const AreaSampler surface(mesh);
  const double total = surface.area();
  std::vector<SurfaceSample> spots;
  if (!(total > 0) || options.max_count == 0) return spots;
  const double tries = std::ceil(kTries * total / (options.spacing * options.spacing));
  if (!(tries <= kMostTries))
    throw Error(
        ErrorCode::too_large,
        fmt::format("{:.4g} m^2 contain too many points {:.3g} m apart", total, options.spacing),
        {}, "use a larger spacing");

  const auto count = static_cast<uint64_t>(std::max(tries, kTries));
  progress.begin("scattering", count);
  Cubes cubes(options.spacing);
  for (uint64_t i = 0; i < count; ++i) {
    if (i % 65536 == 0) progress.check();
    progress.advance();
    const SurfaceSample spot = surface.sample(options.key.at(i));
    if (!cubes.is_free(spot.position)) continue;
    cubes.add(spot.position);
    spots.push_back(spot);
  }
  progress.end();

  if (options.keep_probability) {
    std::vector<uint8_t> stays(spots.size());
    parallel_for(
        spots.size(),
        [&](size_t i) {
          RandomStream random(spots[i].key.at("share"));
          stays[i] = random.uniform() < options.keep_probability(spots[i]);
        },
        64);
    size_t kept = 0;
    for (size_t i = 0; i < spots.size(); ++i)
      if (stays[i]) spots[kept++] = spots[i];
    spots.erase(spots.begin() + static_cast<std::ptrdiff_t>(kept), spots.end());
  }
  if (spots.size() > options.max_count)
    spots.erase(spots.begin() + static_cast<std::ptrdiff_t>(options.max_count), spots.end());
  return spots;
}

}  // namespace vug::mesh
