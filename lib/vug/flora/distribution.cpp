// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/flora/distribution.h>

#include <fmt/format.h>

namespace vug::flora {

/// The times between such events are exponential; events before `mean` are counted.
uint64_t poisson(double mean, RandomStream& random) {
  uint64_t count = 0;
  for (double time = -maths::log(1 - random.uniform()); time < mean;
       time -= maths::log(1 - random.uniform()))
    ++count;
  return count;
}

void require_density(double density, double area) {
  if (!(density > 0))
    throw Error(ErrorCode::bad_input, fmt::format("invalid density {}: must be above 0", density));
  if (!(density * area <= kMaxPoints))
    throw Error(
        ErrorCode::too_large,
        fmt::format("{:.4g} m^2 with {:.4g} points per m^2 exceed the limit of {:.4g} points", area,
                    density, kMaxPoints));
}

}  // namespace vug::flora

namespace vug {

std::optional<flora::DistributionPtr> ValueTraits<flora::DistributionPtr>::read(const Value& v) {
  const auto* name = v.get<Value::Name>();
  if (!name || !find_kind(flora::distributions(), name->text)) return ObjectTraits::read(v);
  return make_product(flora::distributions(), name->text);
}

}  // namespace vug
