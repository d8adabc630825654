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
  const render::Region& region = picture.region;
  const bool rendered =
      out.x >= region.x0 && out.x < region.x1 && out.y >= region.y0 && out.y < region.y1;
  if (rendered) out.light = Vec3d(0, 0, 0);
  const char* const names[] = {"R", "G", "B"};
  for (int i = 0; i < 3; ++i) {
    const int channel = picture.light->find_channel(names[i]);
    if (rendered && channel >= 0)
      (*out.light)[i] = static_cast<double>(
          picture.light->at(out.x - region.x0, out.y - region.y0, static_cast<size_t>(channel)));
    const int index = 3 * (out.y * picture.width + out.x) + i;
    out.shown[static_cast<size_t>(i)] = picture.rgb.at(static_cast<size_t>(index));
  }
  out.samples = rendered ? picture.samples : 0;
  out.pick = pick(picture.scene, x, y);
  if (!out.pick) return out;
  for (const DeclaredPlace& each : out.pick->declared)
    if (each.kind == "material" && !out.material) out.material = each;
  return out;
}

std::string describe(const PixelReport& report) {
  std::string out = "outside of the region";
  if (const auto& light = report.light)
    out = fmt::format("({:.4g}, {:.4g}, {:.4g})", light->x, light->y, light->z);
  out += fmt::format(" shown as {} {} {}", report.shown[0], report.shown[1], report.shown[2]);
  if (!report.pick) return out + ", no object";
  out += fmt::format(", object {}, material {}", report.pick->object, report.pick->material);
  return out;
}

}  // namespace vug::viewport
