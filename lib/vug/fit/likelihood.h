// SPDX-License-Identifier: Apache-2.0
// Likelihoods: the bits that the pixels of a region cost if the model treats them as one region.
#pragma once

#include <vug/base/schema.h>
#include <vug/fit/evidence/evidence.h>
#include <vug/fit/model/rules.h>

#include <memory>

namespace vug::fit {

/// A code for the pixels of one region; immutable and shared by several chains.
class Likelihood {
 public:
  virtual ~Likelihood() = default;
  /// Bits for the sums over the region; 0 without pixels.
  virtual double bits(RegionType type, const Sums& sums) const = 0;
  /// Whether the lanes are code lengths under each RegionType instead of cluster counts.
  virtual bool is_supervised() const { return false; }
};
using LikelihoodPtr = std::shared_ptr<const Likelihood>;

struct LikelihoodKind {
  KindInfo info;
  /// Creates the likelihood for evidence of this size and number of lanes.
  std::function<LikelihoodPtr(const Evidence&)> make;
};

/// One file per kind in likelihoods/.
const std::vector<const LikelihoodKind*>& likelihood_kinds();
/// Looks up a kind by name; Error(bad_input) suggests the nearest name.
LikelihoodPtr make_likelihood(const std::string& name, const Evidence& evidence);

/// Step in bits of the lanes of supervised evidence, which are in the order of RegionType.
constexpr double kBitStep = 1.0 / 64;

}  // namespace vug::fit

/// Opens the one definition that the file of a likelihood exports; used outside of any namespace.
#define VUG_LIKELIHOOD(name) VUG_EXPORT_KIND(vug::fit, LikelihoodKind, name##_likelihood)
