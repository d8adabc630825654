// SPDX-License-Identifier: Apache-2.0
// Point clouds from rendered pictures with positions.
#include <vug/base/error.h>
#include <vug/image/io.h>
#include <vug/scan/read.h>

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace vug::scan {
namespace {

/// Depth in metres from which pixels show no surface.
constexpr float kNowhere = 1e10f;

std::array<size_t, 3> layer(const image::Image& picture, const std::string& name) {
  std::array<size_t, 3> found{};
  for (size_t i = 0; i < 3; ++i) {
    const int at = picture.find_channel(fmt::format("{}.{}", name, "XYZ"[i]));
    if (at < 0) return {};
    found[i] = static_cast<size_t>(at);
  }
  return found;
}

}  // namespace

PointCloud read_picture(const std::filesystem::path& path, const ReadOptions& options) {
  const image::FileInfo info = image::read_info(path);
  require_memory(
      static_cast<double>(info.width) * info.height *
          (4.0 * static_cast<double>(info.channels.size()) + sizeof(Vec3d) + sizeof(Vec3f)),
      options.memory, "the picture " + path.string(), "render a smaller one");
  const image::Image picture = image::read(path);
  const std::array<size_t, 3> position = layer(picture, "P"), normal = layer(picture, "N"), none{};
  const int depth = picture.find_channel("Z");
  if (position == none || depth < 0)
    throw Error(ErrorCode::bad_input, "the picture has no layers P and Z", {path.string(), 1, 1},
                "render it with layers [\"beauty\", \"P\", \"Z\", \"N\"]");
  PointCloud cloud;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const auto read = [&](const std::array<size_t, 3>& from) {
        return Vec3f(picture.at(x, y, from[0]), picture.at(x, y, from[1]),
                     picture.at(x, y, from[2]));
      };
      const Vec3d place(read(position));
      if (!(picture.at(x, y, static_cast<size_t>(depth)) < kNowhere)) continue;
      if (!(std::isfinite(place.x) && std::isfinite(place.y) && std::isfinite(place.z))) {
        ++cloud.dropped;
        continue;
      }
      cloud.positions.push_back(place);
      if (normal != none) cloud.normals.push_back(read(normal));
    }
  if (cloud.size() == 0)
    throw Error(ErrorCode::bad_input, "the picture shows no surface", {path.string(), 1, 1});
  return cloud;
}

}  // namespace vug::scan
