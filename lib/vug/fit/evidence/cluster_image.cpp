// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/median.h>
#include <vug/fit/evidence/cluster_image.h>
#include <vug/fit/evidence/clusters.h>

#include <algorithm>
#include <cmath>

namespace vug::fit {
namespace {

/// Mean and standard deviation of the finite values.
struct Spread {
  double mean = 0, deviation = 0;
};

Spread spread(const Plane& plane) {
  double count = 0, sum = 0, squares = 0;
  for (const float v : plane) {
    if (!std::isfinite(v)) continue;
    count += 1, sum += v, squares += 1.0 * v * v;
  }
  if (count == 0) return {};
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean))};
}

/// Adds a plane divided by its standard deviation; planes that hardly vary get less weight, since
/// they are mostly noise.
void add_weighted(Plane& sum, const Plane& plane, double weight) {
  constexpr double kNoise = 0.5;  // units of L*a*b*
  const Spread of = spread(plane);
  const double scale = weight / std::max(of.deviation, kNoise);
  for (size_t i = 0; i < sum.size(); ++i)
    sum[i] += static_cast<float>(scale * (plane[i] - of.mean));
}

float middle(Plane values) {
  values.erase(
      std::remove_if(values.begin(), values.end(), [](float v) { return !std::isfinite(v); }),
      values.end());
  if (values.empty()) return 0;
  return median(std::move(values));
}

ClusterImage make_cluster_image(int width, int height, std::vector<uint8_t> labels) {
  const int clusters = 1 + *std::max_element(labels.begin(), labels.end());
  return {width, height, clusters, std::move(labels)};
}

/// Merges clusters of one plane, sorted by value, whose mean is closer than `step` to the previous
/// one.
void join(const Plane& values, double step, std::vector<uint8_t>& labels) {
  std::array<double, kMaxLanes> sum{}, count{};
  for (size_t i = 0; i < labels.size(); ++i) sum[labels[i]] += values[i], count[labels[i]] += 1;
  std::array<uint8_t, kMaxLanes> now{};
  for (size_t k = 1; k < now.size() && count[k] > 0; ++k) {
    const double gap = sum[k] / count[k] - sum[k - 1] / count[k - 1];
    now[k] = static_cast<uint8_t>(now[k - 1] + (gap < step ? 0 : 1));
  }
  for (uint8_t& one : labels) one = now[one];
}

/// Clusters by depth, deepest first; holes, if any, form the first cluster.
std::vector<uint8_t> clusters_of_depths(const Plane& depths, const ClusterImageOptions& options,
                                        RandomKey key) {
  if (options.depth_clusters < 2 || options.depth_clusters >= kMaxLanes)
    throw Error(ErrorCode::bad_input, "invalid number of depth clusters: must be 2 to 7");
  const float from = middle(depths), most = static_cast<float>(options.depth_range);
  Planes known{0, 1, {{}}};
  for (const float depth : depths)
    if (std::isfinite(depth)) known.planes[0].push_back(std::clamp(from - depth, -most, most));
  known.width = static_cast<int>(known.planes[0].size());
  const bool holes = known.pixels() < depths.size();
  std::vector<uint8_t> found;
  if (known.width > 0) found = cluster(known, {.clusters = options.depth_clusters}, key);
  if (!found.empty()) join(known.planes[0], options.min_step, found);
  std::vector<uint8_t> out;
  size_t at = 0;
  for (const float depth : depths)
    out.push_back(std::isfinite(depth) ? static_cast<uint8_t>(found[at++] + (holes ? 1 : 0))
                                       : uint8_t{0});
  return out;
}

}  // namespace

Planes glass_cue(const image::Image& linear) {
  const Planes lab = to_lab(linear), flat = high_pass(lab);
  const int width = lab.width, height = lab.height, unit = box_unit(height);
  const auto soft = [&](const Plane& plane, int half) {
    return BoxFilter(width, height, plane).mean(half);
  };
  const BoxFilter light(width, height, lab.planes[0]);
  Planes out{width, height, {Plane(lab.pixels(), 0)}};
  // Weights by how well each cue separates windows from the rest on stone facades
  // (docs/explanation/theory/facades.md).
  add_weighted(out.planes[0], soft(flat.planes[2], unit), 1);
  add_weighted(out.planes[0], soft(flat.planes[1], unit), 0.5);
  add_weighted(out.planes[0], difference(light.mean(3 * unit), light.rows(unit)), 0.5);
  add_weighted(out.planes[0],
               soft(central_differences(width, height, lab.planes[0], true), 4 * unit), -1);
  // Reduces regions larger than windows, such as shops, sky and shadows, to their borders.
  out.planes[0] = difference(out.planes[0], soft(out.planes[0], std::max(1, height / 14)));
  return out;
}

ClusterImage cluster_image(const image::Image* linear, const image::Image* depth,
                           const ClusterImageOptions& options, RandomKey key) {
  if (!linear && !depth)
    throw Error(ErrorCode::bad_input, "a cluster image needs a photo or depths");
  if (depth && depth->channels.size() != 1)
    throw Error(ErrorCode::bad_input, "the picture of depths must have one channel");
  if (linear && depth && (linear->width != depth->width || linear->height != depth->height))
    throw Error(ErrorCode::bad_input, "the photo and the depths differ in size");
  const image::Image& any = linear ? *linear : *depth;
  if (any.pixel_count() == 0) throw Error(ErrorCode::bad_input, "the picture has no pixels");
  if (depth) {
    const bool flat = spread(depth->pixels).deviation < options.min_relief &&
                      std::all_of(depth->pixels.begin(), depth->pixels.end(),
                                  [](float v) { return std::isfinite(v); });
    if (!flat || !linear)
      return make_cluster_image(any.width, any.height,
                                clusters_of_depths(depth->pixels, options, key));
  }
  return make_cluster_image(any.width, any.height,
                            cluster(glass_cue(*linear), {.clusters = options.photo_clusters}, key));
}

}  // namespace vug::fit
