// SPDX-License-Identifier: Apache-2.0
#include <vug/base/quantile.h>
#include <vug/image/brightness.h>
#include <vug/picture/exposure.h>
#include <vug/scout/illumination.h>
#include <vug/scout/preflight.h>
#include <vug/scout/trace_view.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::scout {
namespace {

constexpr int kWidth = 48, kHeight = 27;
// A view of a whole cave from outside is further away than one in a cave.
constexpr double kNothing = 50;         // metres
constexpr double kNothingBySize = 1.2;  // diagonals of the scene
constexpr double kBlack = 0.02, kBurnt = 8, kBurntShare = 0.02;

/// The luminances of the pixels that show a surface; 0 if there is none.
std::vector<float> of_surfaces(const View& view, const std::vector<float>& luminance) {
  std::vector<float> seen;
  for (size_t i = 0; i < luminance.size(); ++i)
    if (view.pixels[i].object != kSky) seen.push_back(luminance[i]);
  if (seen.empty()) seen.push_back(0);
  return seen;
}

}  // namespace

std::vector<PreflightFinding> preflight(const render::PreparedRender& prepared,
                                        const shot::OutputSettings& settings) {
  std::vector<PreflightFinding> found;
  if (prepared.scene->objects.empty()) return found;
  const render::PreparedScene& world = *prepared.world;
  const View view = trace_view(world, *prepared.scene->camera, kWidth, kHeight);
  const auto nearest =
      std::min_element(view.pixels.begin(), view.pixels.end(),
                       [](const Seen& a, const Seen& b) { return a.distance < b.distance; });
  const double size = static_cast<double>(world.bounds().size().length());
  const double limit = std::max(kNothing, kNothingBySize * size);
  if (static_cast<double>(nearest->distance) > limit) {
    const Vec3f middle = world.bounds().center();
    found.push_back(
        {false, fmt::format("the camera sees nothing within {:.0f} m", limit),
         fmt::format("the scene is around ({:.3g}, {:.3g}, {:.3g}): move the eye closer "
                     "to it, or make it the target",
                     middle.x, middle.y, middle.z)});
    if (nearest->object == kSky) return found;
  }
  if (prepared.scene->medium && prepared.scene->medium->is_emissive()) return found;
  const std::vector<float> luminance =
      of_surfaces(view, illuminate(world, prepared.scene->lights, view, RandomKey(0), {.rays = 4}));
  const image::Image picture = grey_picture(luminance);
  const auto bright = static_cast<double>(quantile(luminance, 0.99));
  const auto metered = image::metered_exposure(picture, settings.working_space);
  if (!metered || !(bright > 0)) {  // single rays may pass a seam of a mesh
    found.push_back({true, "hardly any light reaches the picture",
                     "add a lamp in view of these surfaces; 'vug scout --relight' proposes some"});
    return found;
  }
  const double stops = picture::exposure_stops(settings, picture), factor = std::exp2(stops);
  const std::string remedy =
      fmt::format("--exposure {:.1f} or 'exposure auto' would show it; the exposure is {:.1f}",
                  *metered, stops);
  if (bright * factor < kBlack)
    found.push_back({true, "the picture will be black", remedy});
  else if (image::fraction_above(picture, kBurnt / factor, settings.working_space) > kBurntShare)
    found.push_back({true, "parts of the picture will be burnt out", remedy});
  return found;
}

}  // namespace vug::scout
