// SPDX-License-Identifier: Apache-2.0
// Interface of spatial distributions of plants in a plot, which are point processes in the plane.
#pragma once

#include <vug/base/kind.h>
#include <vug/base/progress.h>
#include <vug/flora/plot.h>

#include <memory>
#include <vector>

namespace vug::flora {

/// One hectare in square metres, the unit of stem densities in forestry.
inline constexpr double kHectare = 10000;

/// Maximum number of points of a process; Error(too_large) beyond it.
inline constexpr double kMaxPoints = 1 << 24;

/// A random point set in a plot. Shared and immutable; the same key gives the same points on any
/// machine.
class Distribution {
 public:
  virtual ~Distribution() = default;
  /// `density` is the expected number of points per square metre, above 0; 0 is only valid for a
  /// process with fills() (else Error(bad_input)). In processes without interaction points keep
  /// their positions when a higher density adds others.
  virtual std::vector<Vec2d> points(const Plot& plot, double density, RandomKey key,
                                    Progress& progress) const = 0;
  /// Whether density 0 means as many points as fit.
  virtual bool fills() const { return false; }
};
using DistributionPtr = std::shared_ptr<const Distribution>;

using DistributionKind = Kind<DistributionPtr>;
/// Generated from the list in CMakeLists.txt.
const Kinds<DistributionPtr>& distributions();

/// A Poisson deviate: the number of independent events with the given mean.
uint64_t poisson(double mean, RandomStream& random);

/// Throws unless the density is above 0 and the number of points is within the limit.
void require_density(double density, double area);

/// A kind for a class constructed from its parameter struct P, which has `static void
/// describe(Schema<P>&)`.
template <class P, class Process>
DistributionKind distribution_kind(std::string name) {
  return make_kind<DistributionPtr, P>(
      std::move(name), "distribution",
      [](const P& params) -> DistributionPtr { return std::make_shared<const Process>(params); });
}

}  // namespace vug::flora

/// Opens the one definition that the file of a distribution exports; see VUG_EXPORT_KIND.
#define VUG_DISTRIBUTION_KIND(name) \
  VUG_EXPORT_KIND(vug::flora, DistributionKind, name##_distribution)

namespace vug {

/// A bare name denotes a distribution with default parameters.
template <>
struct ValueTraits<flora::DistributionPtr> : ObjectTraits<flora::DistributionPtr> {
  static constexpr const char* kWord = "distribution";
  static std::optional<flora::DistributionPtr> read(const Value& v);
};

}  // namespace vug
