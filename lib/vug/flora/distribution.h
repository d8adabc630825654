// How plants stand in a plot: point processes in the plane.
#pragma once

#include <vug/base/kind.h>
#include <vug/base/progress.h>
#include <vug/flora/plot.h>

#include <memory>
#include <vector>

namespace vug::flora {

/// One hectare in square metres: foresters count stems by it.
inline constexpr double kHectare = 10000;

/// Points that any process makes at most; Error(too_large) beyond.
inline constexpr double kMaxPoints = 1 << 24;

/// A random set of points in a plot. Shared and immutable; the same key gives the same points on
/// any machine.
class Distribution {
 public:
  virtual ~Distribution() = default;
  /// `density`: points for each square metre that are to be expected, above 0; only a process that
  /// fills() takes 0 (else Error(bad_input)). Points of processes without
  /// interaction stay where they are when others come in with a higher density.
  virtual std::vector<Vec2d> points(const Plot& plot, double density, RandomKey key,
                                    Progress& progress) const = 0;
  /// Whether density 0 is as many as fit.
  virtual bool fills() const { return false; }
};
using DistributionPtr = std::shared_ptr<const Distribution>;

using DistributionKind = Kind<DistributionPtr>;
/// Made from the list in CMakeLists.txt.
const Kinds<DistributionPtr>& distributions();

/// A number of events that come independently, `mean` of them on average: a Poisson deviate.
uint64_t poisson(double mean, RandomStream& random);

/// Throws unless the density is above 0 and the points are not too many.
void require_density(double density, double area);

/// A kind for a class that is constructed from its parameter struct P, which has
/// `static void describe(Schema<P>&)`.
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

/// The name alone stands for a distribution with its defaults.
template <>
struct ValueTraits<flora::DistributionPtr> : ObjectTraits<flora::DistributionPtr> {
  static constexpr const char* kWord = "distribution";
  static std::optional<flora::DistributionPtr> read(const Value& v);
};

}  // namespace vug
