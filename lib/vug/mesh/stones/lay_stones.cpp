// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/mesh/stones/lay_stones.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::mesh {
namespace {

constexpr int kCoarsenessSteps = 20;     // Of the table of `sorting`.
constexpr double kMostDarts = 1u << 26;  // Places that are drawn at most.

struct Dart {
  SurfaceSample spot;
  double diameter = 0;
};

/// The factors of `sorting` over a table of coarsenesses.
class Sorting {
 public:
  Sorting(const std::vector<StoneClass>& classes, double spread) {
    for (int i = 0; i <= kCoarsenessSteps; ++i)
      table_.push_back(sorting(classes, static_cast<double>(i) / kCoarsenessSteps, spread));
  }
  double factor(size_t stone_class, double coarse) const {
    const double at = std::clamp(coarse, 0.0, 1.0) * kCoarsenessSteps;
    const auto i = static_cast<size_t>(std::min(std::floor(at), kCoarsenessSteps - 1.0));
    const double t = at - static_cast<double>(i);
    return table_[i][stone_class] * (1 - t) + table_[i + 1][stone_class] * t;
  }
  double largest(size_t stone_class) const {
    double most = 0;
    for (const std::vector<double>& row : table_) most = std::max(most, row[stone_class]);
    return most;
  }

 private:
  std::vector<std::vector<double>> table_;
};

/// The places of the stones of a class, in the order of their random keys.
std::vector<Dart> darts_of(const AreaSampler& surface, const StoneClass& one, double frequency,
                           const std::function<double(const SurfaceSample&)>& probability,
                           RandomKey key, const LayOptions& options) {
  const double each = 0.25 * kPi * one.mean_diameter() * one.mean_diameter();
  const double wanted = options.cover * one.cover * frequency * surface.area() / each;
  if (!(wanted <= kMostDarts))
    throw Error(ErrorCode::too_large,
                fmt::format("{:.4g} m^2 of ground need {:.3g} stones of {:.3g} m", surface.area(),
                            wanted, one.smallest),
                {}, "use larger stones, or cover less");
  RandomStream rounding(key.at("count"));
  const auto count = static_cast<size_t>(wanted + rounding.uniform());
  std::vector<Dart> darts(count);
  std::vector<uint8_t> stays(count);
  parallel_for(
      count,
      [&](size_t i) {
        const RandomKey own = key.at(i);
        darts[i].spot = surface.sample(own);
        RandomStream random(own.at("size"));
        darts[i].diameter =
            one.smallest * maths::exp(random.uniform() * maths::log(one.largest / one.smallest));
        stays[i] = random.uniform() < probability(darts[i].spot);
      },
      256);
  size_t kept = 0;
  for (size_t i = 0; i < count; ++i)
    if (stays[i]) darts[kept++] = darts[i];
  darts.resize(kept);
  return darts;
}

}  // namespace

std::vector<LaidStone> lay_stones(const Mesh& ground, std::vector<StoneShape> shapes,
                                  const LayOptions& options, Progress& progress) {
  std::vector<LaidStone> laid;
  const AreaSampler surface(ground, maths::cos(options.steepest));
  if (!(surface.area() > 0) || shapes.empty()) return laid;
  const std::vector<StoneClass> classes = stone_classes(options.sizes);
  const Sorting sorted(classes, options.spread);
  std::vector<Dart> darts;
  for (size_t c = 0; c < classes.size(); ++c) {
    const double frequency = options.coarse ? sorted.largest(c) : 1;
    const auto probability = [&](const SurfaceSample& spot) {
      double p = options.keep_probability ? options.keep_probability(spot) : 1;
      if (options.coarse && p > 0) p *= sorted.factor(c, options.coarse(spot)) / frequency;
      return p;
    };
    const std::vector<Dart> more =
        darts_of(surface, classes[c], frequency, probability, options.key.at(c), options);
    darts.insert(darts.end(), more.begin(), more.end());
    if (darts.size() > options.max_count)
      throw Error(
          ErrorCode::bad_input,
          fmt::format("covering {:.3g} m^2 of ground needs more than {} stones, most of them "
                      "smaller than {:.3g} m",
                      surface.area(), options.max_count, classes[c].largest),
          {}, "use a larger smallest size, cover less, restrict 'where', or raise 'count'");
  }
  StoneBed bed(ground, std::move(shapes),
               {.cell = std::max(options.sizes.smallest, 0.25 * options.sizes.largest)});
  progress.begin("laying stones", darts.size());
  for (const Dart& dart : darts) {
    progress.advance();
    if (!bed.add(options.choose_shape(dart.spot.key), dart.diameter, dart.spot.position,
                 dart.spot.key.at("rest")))
      continue;
    laid.push_back({bed.stones().back(), dart.spot.key});
    laid.back().stone.rest.pose.centre.y -= options.sink * dart.diameter;
  }
  progress.end();
  return laid;
}

}  // namespace vug::mesh
