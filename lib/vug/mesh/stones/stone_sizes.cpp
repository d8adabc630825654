// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/mesh/stones/stone_sizes.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::mesh {

double StoneClass::mean_diameter() const {
  const double ratio = maths::log(largest / smallest);
  if (ratio < 1e-9) return smallest;
  return std::sqrt((largest * largest - smallest * smallest) / (2 * ratio));
}

std::vector<StoneClass> stone_classes(const StoneSizes& sizes) {
  if (!(sizes.smallest > 0 && sizes.smallest <= sizes.largest && sizes.typical > 0 &&
        sizes.uniformity > 0))
    throw Error(
        ErrorCode::bad_input,
        fmt::format("invalid sizes of stones from {:g} m to {:g} m: the first must be above "
                    "0 and at most the second",
                    sizes.smallest, sizes.largest));
  const double range = maths::log(sizes.largest / sizes.smallest);
  const int count = std::max(1, static_cast<int>(std::ceil(4 * range / maths::log(2))));
  const auto mass_below = [&](double d) {
    return 1 - maths::exp(-maths::pow(d / sizes.typical, sizes.uniformity));
  };
  std::vector<StoneClass> classes;
  double sum = 0;
  for (int i = count - 1; i >= 0; --i) {
    StoneClass one;
    one.smallest = sizes.smallest * maths::exp(range * i / count);
    one.largest = sizes.smallest * maths::exp(range * (i + 1) / count);
    // The area in plan of a mass of stones is inverse to their diameter.
    const double mass = range > 0 ? mass_below(one.largest) - mass_below(one.smallest) : 1;
    one.cover = mass / one.mean_diameter();
    sum += one.cover;
    classes.push_back(one);
  }
  if (!(sum > 0))
    throw Error(ErrorCode::bad_input,
                fmt::format("no stone of a typical size of {:g} m is between {:g} m and {:g} m",
                            sizes.typical, sizes.smallest, sizes.largest),
                {}, "use a typical size between the smallest and the largest");
  for (StoneClass& one : classes) one.cover /= sum;
  return classes;
}

std::vector<double> sorting(const std::vector<StoneClass>& classes, double coarse, double spread) {
  const double low = maths::log(classes.back().smallest);
  const double range = std::max(maths::log(classes.front().largest) - low, 1e-9);
  std::vector<double> factors;
  double sum = 0;
  for (const StoneClass& one : classes) {
    const double size = (0.5 * maths::log(one.smallest * one.largest) - low) / range;
    const double away = (size - coarse) / spread;
    factors.push_back(maths::exp(-0.5 * std::min(away * away, 1000.0)));
    sum += one.cover * factors.back();
  }
  for (double& factor : factors) factor /= sum;
  return factors;
}

}  // namespace vug::mesh
