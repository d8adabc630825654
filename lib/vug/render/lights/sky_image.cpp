// SPDX-License-Identifier: Apache-2.0
// Sky from a lat-long picture.
#include <vug/base/error.h>
#include <vug/image/io.h>
#include <vug/render/kind.h>
#include <vug/render/lighting/environment_map.h>
#include <vug/render/lighting/light_output.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::render {
namespace {

struct SkyImage : LightLinking {
  std::filesystem::path file;
  double gain = 1;
  double turn = 0;

  static void describe(Schema<SkyImage>& s) {
    s.doc("A sky from a lat-long picture: up is y, the middle column points towards -z.")
        .cite("pharr2023pbr")
        .param("file", &SkyImage::file,
               {.doc = "Picture, linear (EXR, HDR) or sRGB (PNG).", .required = true})
        .param("gain", &SkyImage::gain, {.doc = "Factor on the picture's values.", .min = 0})
        .param("turn", &SkyImage::turn,
               {.doc = "Rotates the sky about the y axis, to the left as seen from above.",
                .dimension = Dimension::angle});
    describe_linking(s);
  }
};

std::vector<Rgb> texels(const SkyImage& p, const image::Image& picture) {
  std::vector<Rgb> out;
  const image::ColourMatrix to_rec709 = image::to_rec709(image::read_info(p.file));
  for (size_t i = 0; i < picture.pixel_count(); ++i) {
    Rgb c(picture.pixels[3 * i], picture.pixels[3 * i + 1], picture.pixels[3 * i + 2]);
    c = to_rec709(c);
    for (int k = 0; k < 3; ++k) {
      if (!std::isfinite(c[k]))
        throw Error(
            ErrorCode::bad_input,
            fmt::format("the sky picture '{}' has values that are not finite", p.file.string()));
      c[k] = std::max(0.0f, c[k]) * static_cast<float>(p.gain);
    }
    out.push_back(c);
  }
  return out;
}

class SkyImageLight final : public EnvironmentMap {
 public:
  explicit SkyImageLight(const SkyImage& p)
      : SkyImageLight(p, image::read(p.file, {.linear = true}).select({"R", "G", "B"})) {}

 private:
  SkyImageLight(const SkyImage& p, const image::Image& picture)
      : EnvironmentMap(linking_of(p), static_cast<size_t>(picture.width),
                       static_cast<size_t>(picture.height), texels(p, picture), p.turn) {}
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(sky_image, light, LightPtr, SkyImage, SkyImageLight)
