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

/// The squared noise of the tiles.
struct TileNoises {
  std::vector<double> own;   ///< Sum over the pixels of each tile.
  std::vector<double> near;  ///< Mean over the pixels of each tile and its eight neighbours.
};

TileNoises tile_noises(const RenderState& state) {
  const double floor = kFloorOfKey * key_of(state);
  TileNoises out{std::vector<double>(state.done.size()), std::vector<double>(state.done.size())};
  std::vector<double> pixels(state.done.size());
  for (size_t i = 0; i < out.own.size(); ++i) {
    const Region tile = state.tile(i);
    out.own[i] = squared_noise(state.film, tile, floor);
    pixels[i] = static_cast<double>(tile.pixels());
  }
  const int across = (state.region.width() + state.tile_size - 1) / state.tile_size;
  const int down = static_cast<int>(out.own.size()) / across;
  const auto number = [&](int x, int y) {
    return static_cast<size_t>(y) * static_cast<size_t>(across) + static_cast<size_t>(x);
  };
  for (int y = 0; y < down; ++y)
    for (int x = 0; x < across; ++x) {
      double near = 0, count = 0;
      for (int v = std::max(0, y - 1); v <= std::min(down - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(across - 1, x + 1); ++u) {
          const size_t neighbour = number(u, v);
          near += out.own[neighbour], count += pixels[neighbour];
        }
      out.near[number(x, y)] = near / count;
    }
  return out;
}

/// The samples after which a tile of that squared noise is expected to converge. Tiles stop after
/// powers of two.
double expected_samples(double squared, double limit, double done, double most) {
  const double needed = done * squared / (limit * limit);
  double stop = kMinAdaptiveSamples;
  while (stop < needed && stop < most) stop *= 2;
  return std::min(stop, most);
}

}  // namespace

void mark_converged(RenderState& state, double noise) {
  const TileNoises noises = tile_noises(state);
  for (size_t tile = 0; tile < noises.near.size(); ++tile)
    if (state.done[tile] - state.begin >= kMinAdaptiveSamples && noises.near[tile] <= noise * noise)
      state.converged[tile] = 1;
}

NoiseReport noise_report(const RenderState& state, double noise) {
  const TileNoises noises = tile_noises(state);
  const auto most = static_cast<double>(state.end - state.begin);
  NoiseReport report;
  double pixels = 0;
  for (size_t tile = 0; tile < noises.own.size(); ++tile) {
    const auto area = static_cast<double>(state.tile(tile).pixels());
    const auto done = static_cast<double>(state.done[tile] - state.begin);
    pixels += area;
    report.noise += noises.own[tile];
    report.samples += area * done;
    if (!state.converged[tile])
      report.missing +=
          area * std::max(0.0, expected_samples(noises.near[tile], noise, done, most) - done);
  }
  report.noise = std::sqrt(report.noise / pixels);
  report.samples /= pixels;
  return report;
}

}  // namespace vug::render
