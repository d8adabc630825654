// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/render/lobes/fuzz.h>

#include <array>

namespace vug::render {
namespace {

constexpr int kFuzzCosines = 32, kFuzzRoughnesses = 16;
constexpr float kMinFuzzRoughness = 0.1f;

/// Slope distribution over visibility (smooth form of Neubelt and Pettineo), in 1/sr.
float fibres(const Vec3f& out, const Vec3f& in, float roughness) {
  const Vec3f h = normalized(out + in);
  const auto sine = static_cast<double>(std::sqrt(std::max(0.0f, 1 - h.z * h.z)));
  const double power = 1 / static_cast<double>(roughness);
  const double density = (2 + power) * (sine > 0 ? maths::pow(sine, power) : 0) / (2 * kPi);
  return static_cast<float>(density) / (4 * (out.z + in.z - out.z * in.z));
}

struct FuzzTable {
  std::array<std::array<float, kFuzzCosines>, kFuzzRoughnesses> albedo;
  std::array<float, kFuzzRoughnesses> mean, largest;
};

float fuzz_roughness(int j) {
  return kMinFuzzRoughness +
         (1 - kMinFuzzRoughness) * static_cast<float>(j) / (kFuzzRoughnesses - 1);
}
float fuzz_cosine(int i) {
  const float x = static_cast<float>(i) / (kFuzzCosines - 1);
  return std::max(x * x, 1e-3f);
}

float lerp(float a, float b, float t) { return a + (b - a) * t; }

float along(const std::array<float, kFuzzCosines>& row, float cosine) {
  const float place = std::sqrt(std::clamp(cosine, 0.0f, 1.0f)) * (kFuzzCosines - 1);
  const auto i = static_cast<size_t>(std::min(static_cast<int>(place), kFuzzCosines - 2));
  return lerp(row[i], row[i + 1], place - static_cast<float>(i));
}

const FuzzTable& fuzz_table() {
  static const FuzzTable made = [] {
    constexpr int kSteps = 96, kTurns = 16;
    FuzzTable s{};
    for (size_t j = 0; j < kFuzzRoughnesses; ++j) {
      for (size_t i = 0; i < kFuzzCosines; ++i) {
        const Vec3f out = direction_at(fuzz_cosine(static_cast<int>(i)), 0);
        double sum = 0;
        for (int a = 0; a < kSteps; ++a)
          for (int b = 0; b < kTurns; ++b) {  // half of the azimuths
            const float c = (static_cast<float>(a) + 0.5f) / kSteps;
            const Vec3f in = direction_at(c, (static_cast<float>(b) + 0.5f) / (2 * kTurns));
            sum += static_cast<double>(c * fibres(out, in, fuzz_roughness(static_cast<int>(j))));
          }
        s.albedo[j][i] = static_cast<float>(2 * kPi * sum / (kSteps * kTurns));
        s.largest[j] = std::max(s.largest[j], s.albedo[j][i]);
      }
      constexpr int kFine = 256;
      for (int i = 0; i < kFine; ++i) {
        const float c = (static_cast<float>(i) + 0.5f) / kFine;
        s.mean[j] += 2 * c * along(s.albedo[j], c) / kFine;
      }
    }
    return s;
  }();
  return made;
}

struct RoughnessPosition {
  size_t at;
  float share;
  explicit RoughnessPosition(float roughness) {
    const float place = (std::clamp(roughness, kMinFuzzRoughness, 1.0f) - kMinFuzzRoughness) /
                        (1 - kMinFuzzRoughness) * (kFuzzRoughnesses - 1);
    at = static_cast<size_t>(std::min(static_cast<int>(place), kFuzzRoughnesses - 2));
    share = place - static_cast<float>(at);
  }
  float of(const std::array<float, kFuzzRoughnesses>& v) const {
    return lerp(v[at], v[at + 1], share);
  }
};

float albedo_at(float cosine, float roughness) {
  const RoughnessPosition row(roughness);
  return lerp(along(fuzz_table().albedo[row.at], cosine),
              along(fuzz_table().albedo[row.at + 1], cosine), row.share);
}

}  // namespace

FuzzLobe::FuzzLobe(const Rgb& color, float roughness, const Rgb& below, const Vec3f& out)
    : fibres_(color),
      below_(below),
      out_(out),
      roughness_(std::clamp(roughness, kMinFuzzRoughness, 1.0f)) {
  const RoughnessPosition row(roughness_);
  scale_ = 1 / std::max(1.0f, row.of(fuzz_table().largest));
  clear_ = 1 - scale_ * albedo_at(out.z, roughness_);
  mean_clear_ = 1 - scale_ * row.of(fuzz_table().mean);
}

Scattering FuzzLobe::evaluate(const Vec3f& in) const {
  if (!(in.z > 0)) return {};
  const float entering = 1 - scale_ * albedo_at(in.z, roughness_);
  const float even = in.z / kPif;
  return {below_ * (clear_ * entering / mean_clear_ * even),
          fibres_ * (scale_ * fibres(out_, in, roughness_) * in.z), even};
}

}  // namespace vug::render
