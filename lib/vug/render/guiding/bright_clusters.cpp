// SPDX-License-Identifier: Apache-2.0
#include <vug/render/guiding/bright_clusters.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>

namespace vug::render {
namespace {

/// Cubes brighter than this multiple of the mean are bright.
constexpr double kBright = 3;

using CubeIndex = std::array<int32_t, 3>;
struct CubeHash {
  size_t operator()(const CubeIndex& c) const {
    uint64_t bits = 0;
    for (const int32_t i : c) {
      bits = (bits + static_cast<uint32_t>(i)) * 0x9e3779b97f4a7c15ull;
      bits ^= bits >> 32;
    }
    return bits;
  }
};

struct Cube {
  Vec3f center{0, 0, 0};  ///< Mean position of its samples.
  double luminance = 0;
};

/// Cubes are in the order of their first samples, so that sums do not depend on a hash.
std::vector<Cube> average(const std::vector<RadianceSample>& radiance_samples, float edge) {
  std::unordered_map<CubeIndex, size_t, CubeHash> places;
  std::vector<Cube> cubes;
  std::vector<float> counts;
  for (const RadianceSample& s : radiance_samples) {
    CubeIndex index;
    for (int axis = 0; axis < 3; ++axis)
      index[static_cast<size_t>(axis)] = static_cast<int32_t>(std::floor(s.point[axis] / edge));
    const size_t at = places.emplace(index, cubes.size()).first->second;
    if (at == cubes.size()) cubes.emplace_back(), counts.push_back(0);
    cubes[at].center += s.point;
    cubes[at].luminance += static_cast<double>(s.luminance);
    counts[at] += 1;
  }
  for (size_t i = 0; i < cubes.size(); ++i) {
    cubes[i].center *= 1 / counts[i];
    // One additional sample of 0 halves the weight of a single path.
    cubes[i].luminance /= static_cast<double>(counts[i]) + 1;
  }
  return cubes;
}

/// Cubes that may become one cluster.
struct Group {
  std::vector<Cube> cubes;
  double luminance = 0;
  Box3f box;

  explicit Group(std::vector<Cube> from) : cubes(std::move(from)) {
    box.makeEmpty();
    for (const Cube& cube : cubes) {
      luminance += cube.luminance;
      box.extendBy(cube.center);
    }
  }
  /// Estimated gain of splitting it.
  double spread() const {
    return cubes.size() < 2 ? 0 : luminance * static_cast<double>(length(box.size()));
  }
};

/// Splits the box in the middle of its longest side. The lower half stays in `group`.
Group split(Group& group) {
  const Vec3f size = group.box.size();
  const int axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
  const float middle = 0.5f * (group.box.min[axis] + group.box.max[axis]);
  const auto cut = std::stable_partition(group.cubes.begin(), group.cubes.end(),
                                         [&](const Cube& c) { return c.center[axis] <= middle; });
  Group upper(std::vector<Cube>(cut, group.cubes.end()));
  group = Group(std::vector<Cube>(group.cubes.begin(), cut));
  return upper;
}

}  // namespace

std::vector<BrightCluster> find_bright_clusters(const std::vector<RadianceSample>& radiance_samples,
                                                float edge, size_t most) {
  const double mean = mean_luminance(radiance_samples);
  std::vector<Cube> bright = average(radiance_samples, edge);
  bright.erase(std::remove_if(bright.begin(), bright.end(),
                              [&](const Cube& c) { return !(c.luminance > kBright * mean); }),
               bright.end());
  if (bright.empty()) return {};

  std::vector<Group> groups{Group(std::move(bright))};
  while (groups.size() < most) {
    const auto widest =
        std::max_element(groups.begin(), groups.end(),
                         [](const Group& a, const Group& b) { return a.spread() < b.spread(); });
    if (!(widest->spread() > 0)) break;
    Group upper = split(*widest);
    groups.push_back(std::move(upper));
  }
  std::vector<BrightCluster> clusters;
  for (const Group& group : groups)
    clusters.push_back({group.box.center(), 0.5f * length(group.box.size()) + 0.5f * edge,
                        static_cast<float>(group.luminance) * edge * edge});
  return clusters;
}

}  // namespace vug::render
