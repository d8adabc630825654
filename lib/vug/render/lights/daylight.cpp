// SPDX-License-Identifier: Apache-2.0
// Clear sky: Preetham, Shirley, Smits 1999, "A practical analytic model for daylight", with the
// luminance distribution of Perez et al. Valid for a sun above the horizon and turbidities of 2 to
// 8. Towards sunset and for very clear air its horizon is too bright and too yellow. It has no
// twilight: with the sun below the horizon the sky is black.
#include <vug/base/maths.h>
#include <vug/render/kind.h>
#include <vug/render/lighting/environment_map.h>
#include <vug/render/lighting/light_output.h>
#include <vug/render/lighting/sun_position.h>

#include <algorithm>

namespace vug::render {
namespace {

struct Daylight : SunParams, LightLinking {
  double turbidity = 3;
  Vec3d ground{0.12, 0.11, 0.09};
  double gain = 1;

  static void describe(Schema<Daylight>& s) {
    s.doc("A clear sky without the sun's disk, which is a separate light.").cite("preetham1999");
    describe_sun(s);
    s.param("turbidity", &Daylight::turbidity,
            {.doc = "Turbidity of the air: 2 clear, 8 hazy.", .min = 1.7, .max = 10})
        .param("ground", &Daylight::ground,
               {.doc = "Albedo of the ground below the horizon.", .min = 0, .max = 1})
        .param("gain", &Daylight::gain, {.doc = "Factor on the sky's radiance.", .min = 0});
    describe_linking(s);
  }
};

/// Coefficients of one of luminance Y and chromaticities x, y: slope * turbidity + constant.
struct Perez {
  double a, b, c, d, e;

  double at(double cosine, double gamma, double cos_gamma) const {
    return (1 + a * maths::exp(b / cosine)) *
           (1 + c * maths::exp(d * gamma) + e * cos_gamma * cos_gamma);
  }
};

class Preetham {
 public:
  Preetham(const Vec3d& sun, double t) : sun_(sun) {
    forms_[0] = {0.1787 * t - 1.4630, -0.3554 * t + 0.4275, -0.0227 * t + 5.3251,
                 0.1206 * t - 2.5771, -0.0670 * t + 0.3703};
    forms_[1] = {-0.0193 * t - 0.2592, -0.0665 * t + 0.0008, -0.0004 * t + 0.2125,
                 -0.0641 * t - 0.8989, -0.0033 * t + 0.0452};
    forms_[2] = {-0.0167 * t - 0.2608, -0.0950 * t + 0.0092, -0.0079 * t + 0.2102,
                 -0.0441 * t - 1.6537, -0.0109 * t + 0.0529};
    const double z = maths::acos(std::clamp(sun.y, 0.0, 1.0)), zz = z * z, zzz = zz * z;
    const double chi = (4.0 / 9 - t / 120) * (kPi - 2 * z);
    zenith_[0] = std::max(0.0, (4.0453 * t - 4.9710) * maths::tan(chi) - 0.2155 * t + 2.4192);
    zenith_[1] = t * t * (0.00166 * zzz - 0.00375 * zz + 0.00209 * z) +
                 t * (-0.02903 * zzz + 0.06377 * zz - 0.03202 * z + 0.00394) +
                 (0.11693 * zzz - 0.21196 * zz + 0.06052 * z + 0.25886);
    zenith_[2] = t * t * (0.00275 * zzz - 0.00610 * zz + 0.00317 * z) +
                 t * (-0.04214 * zzz + 0.08970 * zz - 0.04153 * z + 0.00516) +
                 (0.15346 * zzz - 0.26756 * zz + 0.06670 * z + 0.26688);
    for (int i = 0; i < 3; ++i) zenith_[i] /= forms_[i].at(1, z, std::clamp(sun.y, 0.0, 1.0));
  }

  /// In W/sr/m^2, for directions above the horizon; black with the sun below it.
  Vec3d radiance(const Vec3d& direction) const {
    if (!(sun_.y > 0)) return Vec3d(0.0);
    // The formula was not fitted to directions at the horizon.
    const double cosine = std::max(direction.y, 0.01);
    const double cos_gamma = std::clamp(direction.dot(sun_), -1.0, 1.0);
    const double gamma = maths::acos(cos_gamma);
    const auto value = [&](int i) { return zenith_[i] * forms_[i].at(cosine, gamma, cos_gamma); };
    const double luminance = std::max(0.0, value(0)) * 1000 / kLumenPerWatt;  // from kcd/m^2
    const double x = value(1), y = std::max(value(2), 1e-3);
    const Vec3d xyz(x / y * luminance, luminance, (1 - x - y) / y * luminance);
    return {std::max(0.0, 3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z),
            std::max(0.0, -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z),
            std::max(0.0, 0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z)};
  }

 private:
  Vec3d sun_;
  Perez forms_[3] = {};
  double zenith_[3] = {};
};

constexpr size_t kWidth = 512, kHeight = 256;

std::vector<Rgb> daylight_texels(const Daylight& p) {
  const Vec3d sun = p.direction();
  const Preetham model(sun, p.turbidity);
  std::vector<Rgb> out;
  Vec3d irradiance = sun_irradiance(sun, p.turbidity) * std::max(sun.y, 0.0);
  for (size_t row = 0; row < kHeight / 2; ++row) {
    const double polar = kPi * (static_cast<double>(row) + 0.5) / kHeight;
    const double sine = maths::sin(polar), cosine = maths::cos(polar);
    const double cell = 2 * kPi / kWidth * kPi / kHeight * sine;
    for (size_t column = 0; column < kWidth; ++column) {
      const double turn = 2 * kPi * ((static_cast<double>(column) + 0.5) / kWidth - 0.5);
      const Vec3d radiance =
          model.radiance({sine * maths::sin(turn), cosine, -sine * maths::cos(turn)}) * p.gain;
      irradiance += radiance * (cell * cosine);
      out.emplace_back(radiance);
    }
  }
  out.resize(kWidth * kHeight, Rgb(p.ground * irradiance / kPi));
  return out;
}

class DaylightLight final : public EnvironmentMap {
 public:
  explicit DaylightLight(const Daylight& p)
      : EnvironmentMap(linking_of(p), kWidth, kHeight, daylight_texels(p), 0) {}
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(daylight, light, LightPtr, Daylight, DaylightLight)
