// How many bits the pixels of a region cost once the model says that they are one region.
#pragma once

#include <vug/base/schema.h>
#include <vug/fit/evidence/evidence.h>
#include <vug/fit/model/rules.h>

#include <memory>

namespace vug::fit {

/// A code for one region's pixels; immutable, and used by several chains at once.
class Likelihood {
 public:
  virtual ~Likelihood() = default;
  /// Bits, from the sums over the region; 0 for no pixel.
  virtual double bits(RegionType type, const Sums& sums) const = 0;
  /// Whether lanes are code lengths under each Look, and not clusters.
  virtual bool is_supervised() const { return false; }
};
using LikelihoodPtr = std::shared_ptr<const Likelihood>;

struct LikelihoodKind {
  KindInfo info;
  /// For pictures of that size and number of lanes.
  std::function<LikelihoodPtr(const Evidence&)> make;
};

/// One file a kind in likelihoods/.
const std::vector<const LikelihoodKind*>& likelihood_kinds();
/// By name; Error(bad_input) with the nearest one where there is none.
LikelihoodPtr make_likelihood(const std::string& name, const Evidence& evidence);

/// Lanes of supervised evidence hold bits in steps of this size, in the order of Look.
constexpr double kBitStep = 1.0 / 64;

}  // namespace vug::fit

/// Opens the one definition that a likelihood's file exports, from outside of any namespace.
#define VUG_LIKELIHOOD(name) VUG_EXPORT_KIND(vug::fit, LikelihoodKind, name##_likelihood)
