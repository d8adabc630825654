// SPDX-License-Identifier: Apache-2.0
#include <vug/viewport/inspect.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::viewport {

PixelReport inspect(const Preview& picture, double x, double y) {
  const auto pixel = [](double at, int size) {
    return std::clamp(static_cast<int>(at * size), 0, size - 1);
  };
  PixelReport out;
  out.x = pixel(x, picture.width), out.y = pixel(y, picture.height);
  const char* const names[] = {"R", "G", "B"};
  for (int i = 0; i < 3; ++i) {
    const int channel = picture.light->find_channel(names[i]);
    if (channel >= 0)
      out.light[i] =
          static_cast<double>(picture.light->at(out.x, out.y, static_cast<size_t>(channel)));
    const int index = 3 * (out.y * picture.width + out.x) + i;
    out.shown[static_cast<size_t>(i)] = picture.rgb.at(static_cast<size_t>(index));
  }
  out.samples = picture.samples;
  out.pick = pick(picture.scene, x, y);
  if (!out.pick) return out;
  for (const DeclaredPlace& each : out.pick->declared)
    if (each.kind == "material" && !out.material) out.material = each;
  return out;
}

std::string describe(const PixelReport& report) {
  const Vec3d& light = report.light;
  std::string out = fmt::format("({:.4g}, {:.4g}, {:.4g}) shown as {} {} {}", light.x, light.y,
                                light.z, report.shown[0], report.shown[1], report.shown[2]);
  if (!report.pick) return out + ", no object";
  out += fmt::format(", object {}, material {}", report.pick->object, report.pick->material);
  return out;
}

}  // namespace vug::viewport
