// SPDX-License-Identifier: Apache-2.0
#include <vug/base/srgb.h>
#include <vug/image/brightness.h>
#include <vug/image/denoise.h>
#include <vug/image/ocio_view.h>
#include <vug/image/views.h>
#include <vug/render/prepare.h>
#include <vug/scout/contact_sheet.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace vug::scout {
namespace {

constexpr int kColumns = 4, kMargin = 4, kDot = 3;  // pixels

/// Digits of 3 x 5 dots, row by row from the top.
constexpr const char* kDigits[10] = {
    "###"
    "#.#"
    "#.#"
    "#.#"
    "###",
    ".#."
    "##."
    ".#."
    ".#."
    "###",
    "###"
    "..#"
    "###"
    "#.."
    "###",
    "###"
    "..#"
    "###"
    "..#"
    "###",
    "#.#"
    "#.#"
    "###"
    "..#"
    "..#",
    "###"
    "#.."
    "###"
    "..#"
    "###",
    "###"
    "#.."
    "###"
    "#.#"
    "###",
    "###"
    "..#"
    "..#"
    "..#"
    "..#",
    "###"
    "#.#"
    "###"
    "#.#"
    "###",
    "###"
    "#.#"
    "###"
    "..#"
    "###"};

void set(image::Image& sheet, int x, int y, float value) {
  if (x < 0 || y < 0 || x >= sheet.width || y >= sheet.height) return;
  for (size_t c = 0; c < 3; ++c) sheet.at(x, y, c) = value;
}

/// Draws the number white on black with its top left corner at (x, y).
void draw_number(image::Image& sheet, int x, int y, const std::string& number) {
  const int width = kDot * (4 * static_cast<int>(number.size()) + 1), height = kDot * 7;
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u) set(sheet, x + u, y + v, 0);
  for (size_t k = 0; k < number.size(); ++k)
    for (int dot = 0; dot < 15; ++dot) {
      if (kDigits[number[k] - '0'][dot] != '#') continue;
      const int left = x + kDot * (1 + 4 * static_cast<int>(k) + dot % 3);
      const int top = y + kDot * (1 + dot / 3);
      for (int v = 0; v < kDot; ++v)
        for (int u = 0; u < kDot; ++u) set(sheet, left + u, top + v, 1);
    }
}

}  // namespace

image::Image render_thumbnail(const Location& location, const picture::PicturePlan& plan,
                              const Pose& pose, const std::vector<render::LightPtr>& more,
                              const SheetOptions& options, Progress& progress) {
  const shot::RenderSettings& settings = plan.render.settings;
  render::Scene scene = location.scene;
  scene.camera = camera_of(pose);
  scene.lights.insert(scene.lights.end(), more.begin(), more.end());
  render::Options render;
  render.width = options.width, render.height = options.height;
  render.spp = options.spp;
  render.seed = options.seed;
  render.integrator = settings.integrator;
  std::vector<std::string> layers = image::denoising_layers();
  layers.insert(layers.end(), {"beauty", "A"});
  render.aovs = render::scene_aovs(scene, layers);
  render::PrepareOptions part;
  part.world = std::make_shared<const render::PreparedScene>(*location.world, scene,
                                                             std::vector<render::LightPtr>());
  const render::PreparedRender prepared = render::prepare(scene, render, part, progress);
  const image::Image rendered = render::render(prepared, progress);
  image::Image picture = image::denoise(rendered);
  picture.channels = {"R", "G", "B"};
  image::ViewOptions view = image::view_options(
      {settings.view, settings.display, plan.options.config}, settings.working_space);
  view.exposure = image::metered_exposure(image::joined(picture, rendered.select({"A"})),
                                          settings.working_space)
                      .value_or(0);
  return image::display(picture, view);
}

image::Image contact_sheet(const std::vector<image::Image>& pictures) {
  const int width = pictures.at(0).width, height = pictures.at(0).height;
  const int columns = std::min(kColumns, static_cast<int>(pictures.size()));
  const int rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
  image::Image sheet(columns * (width + kMargin) + kMargin, rows * (height + kMargin) + kMargin,
                     {"R", "G", "B"});
  for (size_t i = 0; i < pictures.size(); ++i) {
    const int left = kMargin + static_cast<int>(i) % columns * (width + kMargin);
    const int top = kMargin + static_cast<int>(i) / columns * (height + kMargin);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        for (size_t c = 0; c < 3; ++c)
          sheet.at(left + x, top + y, c) =
              static_cast<float>(srgb_decode(static_cast<double>(pictures[i].at(x, y, c))));
    draw_number(sheet, left, top, std::to_string(i + 1));
  }
  return sheet;
}

}  // namespace vug::scout
