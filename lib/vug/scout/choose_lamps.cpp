// SPDX-License-Identifier: Apache-2.0
// The choice of lamps for a shot, and of their powers.
#include <vug/base/maths.h>
#include <vug/scout/key_ratio.h>
#include <vug/scout/lamps.h>
#include <vug/scout/trace_view.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vug::scout {
namespace {

constexpr size_t kMostLamps = 4;
constexpr std::array<double, 4> kTargets = {0.18, 0.06, 0.015, 0.2};  // by Part
constexpr double kLeastGain = 0.02;   // of the residual, for which a lamp is added
constexpr double kLeastShare = 0.01;  // of the strongest lamp's power
const double kTried = Lamp().lumen;   // of the lamps that are mixed
constexpr double kWideRoom = 10;      // metres: nearer subjects need weaker lamps

/// The mean luminance of each part; 0 for a part that the view lacks.
std::vector<double> part_means(const std::vector<float>& luminance,
                               const std::vector<Part>& parts) {
  std::vector<double> sum(4, 0), count(4, 0);
  for (size_t i = 0; i < parts.size(); ++i) {
    if (parts[i] == Part::none) continue;
    sum[static_cast<size_t>(parts[i])] += static_cast<double>(luminance[i]);
    ++count[static_cast<size_t>(parts[i])];
  }
  for (size_t k = 0; k < 4; ++k)
    if (count[k] > 0) sum[k] /= count[k];
  return sum;
}

/// Errors are compared after a division by the root of the target: neither an absolute error, for
/// which dark parts do not matter, nor a relative one, for which only they do.
std::vector<double> comparable(std::vector<double> means) {
  for (size_t k = 0; k < 4; ++k) means[k] /= std::sqrt(kTargets[k]);
  return means;
}

/// The nearest power of a product: 1, 1.5, 2, 3, 5 or 8 times a power of ten.
double product_power(double lumen) {
  constexpr double kSteps[] = {1, 1.5, 2, 3, 5, 8, 10};
  const double decade = maths::pow(10, std::floor(maths::log(lumen) / maths::log(10.0)));
  double best = decade;
  for (const double step : kSteps)
    if (std::fabs(maths::log(step * decade / lumen)) < std::fabs(maths::log(best / lumen)))
      best = step * decade;
  return best;
}

struct Mix {
  std::vector<size_t> lamps;
  NonNegativeFit fit;
};

/// Adds the lamp that improves the fit most, as long as one does.
Mix best_mix(const std::vector<std::vector<double>>& means, const std::vector<double>& target,
             const KeyRatio& held) {
  Mix best;
  for (const double each : target) best.fit.residual += each * each;
  const double start = best.fit.residual;
  while (best.lamps.size() < kMostLamps) {
    Mix next = best;
    for (size_t i = 0; i < means.size(); ++i) {
      if (std::find(best.lamps.begin(), best.lamps.end(), i) != best.lamps.end()) continue;
      Mix tried;
      tried.lamps = best.lamps;
      tried.lamps.push_back(i);
      std::vector<std::vector<double>> columns;
      for (const size_t k : tried.lamps) columns.push_back(means[k]);
      tried.fit = fit_with_key(std::move(columns), target, held);
      if (tried.fit.residual < next.fit.residual) next = std::move(tried);
    }
    if (next.fit.residual > best.fit.residual - kLeastGain * start) break;
    best = std::move(next);
  }
  return best;
}

/// The lamps of the mix with powers of products, strongest first. `daylight`: the factor between
/// the light of the sky and the targets; 0 without a sky. Then the exposure takes up a common
/// factor, and the lamps are as strong as products can be in a wide room, and weaker in smaller
/// ones.
std::vector<Lamp> powered(const std::vector<Lamp>& places, const Mix& mix, double daylight,
                          double distance) {
  const std::vector<double>& weights = mix.fit.weights;
  double factor = kInfinity, strongest = 0;
  for (size_t k = 0; k < mix.lamps.size(); ++k) {
    strongest = std::max(strongest, weights[k]);
    if (weights[k] > 0)
      factor = std::min(factor, most_lumens(places[mix.lamps[k]].role) / weights[k]);
  }
  const double size = std::min(1.0, distance / kWideRoom);
  std::vector<Lamp> chosen;
  for (size_t k = 0; k < mix.lamps.size(); ++k) {
    if (!(weights[k] > kLeastShare * strongest)) continue;
    Lamp lamp = places[mix.lamps[k]];
    const double lumen = daylight > 0
                             ? std::min(most_lumens(lamp.role), kTried * weights[k] * daylight)
                             : factor * weights[k] * size * size;
    lamp.lumen = std::max(10.0, product_power(lumen));
    chosen.push_back(lamp);
  }
  std::stable_sort(chosen.begin(), chosen.end(),
                   [](const Lamp& a, const Lamp& b) { return a.lumen > b.lumen; });
  return chosen;
}

}  // namespace

std::vector<Lamp> choose_lamps(const Location& location, const render::Camera& camera,
                               const std::vector<std::filesystem::path>& data_folders,
                               const Landmarks& landmarks, RandomKey key, double key_ratio) {
  const View view = trace_view(*location.world, camera);
  const std::vector<Lamp> places = lamp_places(location, camera, view, landmarks, key.at("places"));
  if (places.empty()) return {};
  const std::vector<Part> parts = parts_of(view, landmarks);
  const std::vector<render::LightPtr> lights = lights_of(places, data_folders);
  std::vector<std::vector<double>> means;
  for (size_t i = 0; i < lights.size(); ++i)
    means.push_back(
        comparable(part_means(illuminate(*location.world, {lights[i]}, view, key.at(i)), parts)));
  // The light of the sky is there already: it defines the exposure, and lamps add what is missing.
  const std::vector<double> given =
      part_means(illuminate(*location.world, location.scene.lights, view, key.at("sky")), parts);
  double daylight = 0;
  for (size_t k = 0; k < 4; ++k) daylight = std::max(daylight, given[k] / kTargets[k]);
  std::vector<double> target(4, 0);
  for (const Part part : parts)
    if (part != Part::none) target[static_cast<size_t>(part)] = kTargets[static_cast<size_t>(part)];
  KeyRatio held{0, std::max(1.0, key_ratio), 0};
  for (size_t k = 0; k < 4; ++k)
    if (target[k] > target[held.part] && target[static_cast<size_t>(Part::subject)] == 0)
      held.part = k;
  if (daylight > 0) {
    for (size_t k = 0; k < 4; ++k)
      if (given[k] / kTargets[k] >= daylight) held.part = k;
    held.sky = comparable(given)[held.part] / daylight;
    for (size_t k = 0; k < 4; ++k) target[k] = std::max(0.0, target[k] - given[k] / daylight);
  }
  target = comparable(target);
  const Mix mix = best_mix(means, target, held);
  return powered(places, mix, daylight, median_distance(view));
}

}  // namespace vug::scout
