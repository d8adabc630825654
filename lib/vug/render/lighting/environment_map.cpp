// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/exchange/light.h>
#include <vug/render/lighting/environment_map.h>
#include <vug/render/sampling.h>

#include <algorithm>

namespace vug::render {
namespace {

/// Normalized cumulative sums of non-negative weights, from 0 to 1.
std::vector<float> cumulative(const std::vector<double>& weights, double& total) {
  std::vector<float> table(weights.size() + 1, 0);
  total = 0;
  std::vector<double> sums;
  for (const double w : weights) sums.push_back(total += w);
  for (size_t i = 0; i < weights.size(); ++i)
    table[i + 1] = total > 0 ? static_cast<float>(sums[i] / total)
                             : static_cast<float>(i + 1) / static_cast<float>(weights.size());
  table.back() = 1;
  return table;
}

}  // namespace

/// The interval of a table that contains a number, the position within it, and its probability.
struct EnvironmentMap::Cell {
  size_t index;
  float offset, probability;
};
EnvironmentMap::Cell EnvironmentMap::find_cell(const float* table, size_t cells, float u) {
  const float* above = std::upper_bound(table + 1, table + cells, u);
  const auto index = static_cast<size_t>(above - table) - 1;
  const float p = table[index + 1] - table[index];
  return {index, p > 0 ? std::clamp((u - table[index]) / p, 0.0f, 0.99999994f) : 0.5f, p};
}

EnvironmentMap::EnvironmentMap(LightLinking linking, size_t width, size_t height,
                               std::vector<Rgb> texels, double turn)
    : Light(std::move(linking)),
      width_(width),
      height_(height),
      turn_(static_cast<float>(turn / (2 * kPi))),
      texels_(std::move(texels)) {
  turn_ -= std::floor(turn_);
  build_tables();
}

LightSample EnvironmentMap::sample(const LightSampleContext&, const Vec2f& u) const {
  LightSample s;
  const Cell row = find_cell(rows_.data(), height_, u.y);
  const Cell column = find_cell(columns_.data() + row.index * (width_ + 1), width_, u.x);
  const float v = (static_cast<float>(row.index) + row.offset) / static_cast<float>(height_);
  const float x = (static_cast<float>(column.index) + column.offset) / static_cast<float>(width_);
  s.direction = direction(x, v);
  s.distance = kFar;
  s.pdf = density(row.probability * column.probability, v);
  return s;
}

float EnvironmentMap::pdf(const LightSampleContext&, const Vec3f& direction) const {
  const Vec2f place = locate(direction);
  const size_t row = index_of(place.y, height_), column = index_of(place.x, width_);
  const float* table = columns_.data() + row * (width_ + 1);
  return density((rows_[row + 1] - rows_[row]) * (table[column + 1] - table[column]), place.y);
}

Rgb EnvironmentMap::eval_environment(const Vec3f& direction) const {
  const Vec2f place = locate(direction);
  const float x = place.x * static_cast<float>(width_) - 0.5f;
  const float y = place.y * static_cast<float>(height_) - 0.5f;
  const float fx = std::floor(x), fy = std::floor(y), ax = x - fx, ay = y - fy;
  const long ix = static_cast<long>(fx), iy = static_cast<long>(fy);
  return (texel(ix, iy) * (1 - ax) + texel(ix + 1, iy) * ax) * (1 - ay) +
         (texel(ix, iy + 1) * (1 - ax) + texel(ix + 1, iy + 1) * ax) * ay;
}

bool EnvironmentMap::as_data(exchange::Light& light) const {
  image::Image picture(static_cast<int>(width_), static_cast<int>(height_), {"R", "G", "B"});
  for (size_t i = 0; i < texels_.size(); ++i)
    for (int c = 0; c < 3; ++c) picture.pixels[3 * i + static_cast<size_t>(c)] = texels_[i][c];
  light.shape = exchange::Light::Shape::dome;
  light.place = Transform::rotation({0, 1, 0}, 2 * kPi * static_cast<double>(turn_));
  light.picture = std::make_shared<const image::Image>(std::move(picture));
  return true;
}

size_t EnvironmentMap::index_of(float place, size_t count) {
  return std::min(static_cast<size_t>(place * static_cast<float>(count)), count - 1);
}

const Rgb& EnvironmentMap::texel(long x, long y) const {
  const long w = static_cast<long>(width_), h = static_cast<long>(height_);
  return texels_[static_cast<size_t>(std::clamp(y, 0l, h - 1) * w + ((x % w) + w) % w)];
}

/// Image coordinates in [0, 1]^2, row 0 straight up.
Vec3f EnvironmentMap::direction(float x, float v) const {
  const SinCos across = sincos_turns(x - 0.5f - turn_), down = sincos_turns(0.5f * v);
  return {down.sin * across.sin, down.cos, -down.sin * across.cos};
}

Vec2f EnvironmentMap::locate(const Vec3f& d) const {
  const double across = maths::atan2(static_cast<double>(d.x), static_cast<double>(-d.z));
  float x = static_cast<float>(across / (2 * kPi)) + 0.5f + turn_;
  x -= std::floor(x);
  return {x, static_cast<float>(maths::acos(static_cast<double>(d.y)) / kPi)};
}

/// Converts the probability of a texel to a density over solid angle.
float EnvironmentMap::density(float probability, float v) const {
  const float sine = sincos_turns(0.5f * v).sin;
  const float texels = static_cast<float>(width_ * height_);
  return sine > 0 ? probability * texels / (2 * kPif * kPif * sine) : 0;
}

void EnvironmentMap::build_tables() {
  double total = 0, rows_total = 0;
  std::vector<double> row_weights;
  for (size_t y = 0; y < height_; ++y) {
    const auto sine = static_cast<double>(
        sincos_turns(0.5f * (static_cast<float>(y) + 0.5f) / static_cast<float>(height_)).sin);
    std::vector<double> weights;
    for (size_t x = 0; x < width_; ++x) {
      // Includes the neighbours, since interpolated lookups reach them.
      double w = 0;
      for (long dy = -1; dy <= 1; ++dy)
        for (long dx = -1; dx <= 1; ++dx)
          w += static_cast<double>(
              luminance(texel(static_cast<long>(x) + dx, static_cast<long>(y) + dy)));
      weights.push_back(w * sine / 9);
    }
    const std::vector<float> table = cumulative(weights, total);
    columns_.insert(columns_.end(), table.begin(), table.end());
    row_weights.push_back(total);
  }
  rows_ = cumulative(row_weights, rows_total);
  // The integral of the sine over all texels is their number times 2 / pi.
  mean_luminance_ =
      static_cast<float>(rows_total * 0.5 * kPi / static_cast<double>(width_ * height_));
  importance_ = kPif * mean_luminance_;
}

}  // namespace vug::render
