// SPDX-License-Identifier: Apache-2.0
#include <vug/scout/key_ratio.h>

namespace vug::scout {
namespace {

constexpr double kWeight = 300;  // of the equation, relative to those of the parts

}  // namespace

NonNegativeFit fit_with_key(std::vector<std::vector<double>> columns, std::vector<double> target,
                            const KeyRatio& held) {
  NonNegativeFit fit = fit_non_negative(columns, target);
  size_t key = columns.size();  // none: the sky
  double most = held.sky, all = held.sky;
  for (size_t j = 0; j < columns.size(); ++j) {
    const double light = fit.weights[j] * columns[j][held.part];
    all += light;
    if (held.sky <= 0 && light > most) most = light, key = j;
  }
  if (held.ratio * (all - most) <= most) return fit;
  for (size_t j = 0; j < columns.size(); ++j)
    columns[j].push_back(kWeight * columns[j][held.part] * (j == key ? -1 / held.ratio : 1));
  target.push_back(kWeight * held.sky / held.ratio);
  return fit_non_negative(columns, target);
}

}  // namespace vug::scout
