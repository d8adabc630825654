// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/render/film/adaptive.h>

#include <cmath>

namespace vug::render {
namespace {

constexpr double kFloorOfKey = 0.25;

constexpr double kWeights[] = {0.2126, 0.7152, 0.0722};  // Rec.709 luminance

double light_of(const PixelSum& pixel) {
  double light = 0;
  for (size_t c = 0; c < 3; ++c) light += kWeights[c] * pixel.mean(c);
  return std::max(0.0, light);
}

double mean_light(const Film& film, const Region& region) {
  double sum = 0;
  for (int y = region.y0; y < region.y1; ++y)
    for (int x = region.x0; x < region.x1; ++x) sum += light_of(film.at(x, y));
  return sum / static_cast<double>(region.pixels());
}

/// Sum of the squared noise of the pixels.
double squared_noise(const Film& film, const Region& region, double floor) {
  double sum = 0;
  for (int y = region.y0; y < region.y1; ++y)
    for (int x = region.x0; x < region.x1; ++x) {
      const PixelSum& pixel = film.at(x, y);
      // The channels' errors are assumed to be correlated, which is true except for coloured
      // lights.
      double deviation = 0;
      for (size_t c = 0; c < 3; ++c) deviation += kWeights[c] * std::sqrt(pixel.variance(c));
      const double relative = deviation / std::max(light_of(pixel) + floor, 1e-30);
      sum += relative * relative;
    }
  return sum;
}

/// The log-average luminance of the tiles that receive light.
double key_of(const RenderState& state) {
  double sum = 0, lit = 0;
  for (size_t i = 0; i < state.done.size(); ++i) {
    const double light = mean_light(state.film, state.tile(i));
    if (light > 0) sum += maths::log(light), lit += 1;
  }
  return lit > 0 ? maths::exp(sum / lit) : 0;
}

}  // namespace

void mark_converged(RenderState& state, double noise) {
  const Region& region = state.region;
  const double floor = kFloorOfKey * key_of(state);
  std::vector<double> noises(state.done.size()), pixels(state.done.size());
  for (size_t i = 0; i < noises.size(); ++i) {
    const Region tile = state.tile(i);
    noises[i] = squared_noise(state.film, tile, floor);
    pixels[i] = static_cast<double>(tile.pixels());
  }
  const int across = (region.width() + state.tile_size - 1) / state.tile_size;
  const int down = static_cast<int>(noises.size()) / across;
  const auto number = [&](int x, int y) {
    return static_cast<size_t>(y) * static_cast<size_t>(across) + static_cast<size_t>(x);
  };
  for (int y = 0; y < down; ++y)
    for (int x = 0; x < across; ++x) {
      const size_t tile = number(x, y);
      if (state.converged[tile] || state.done[tile] - state.begin < kMinAdaptiveSamples) continue;
      double near = 0, count = 0;
      for (int v = std::max(0, y - 1); v <= std::min(down - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(across - 1, x + 1); ++u) {
          const size_t neighbour = number(u, v);
          near += noises[neighbour], count += pixels[neighbour];
        }
      if (near <= noise * noise * count) state.converged[tile] = 1;
    }
}

}  // namespace vug::render
