// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <vug/base/error.h>
#include <vug/base/rng.h>
#include <vug/karst/realistic.h>

#include <algorithm>

namespace vug::karst {
namespace {

constexpr int64_t kMostSamples = 1'000'000;  ///< The sum over all attempts; some minutes.

bool all_in_bands(const network::Realism& realism) {
  return std::all_of(realism.network.begin(), realism.network.end(),
                     [](const network::CriterionScore& s) { return s.realism >= 1; });
}

}  // namespace

RealisticNetwork generate_realistic(const Geology& geology, KarstOptions options, int attempts) {
  if (attempts < 1 || attempts > kMostAttempts)
    throw Error(ErrorCode::bad_input, fmt::format("{} attempts were requested", attempts), {},
                fmt::format("the number of attempts must be between 1 and {}", kMostAttempts));
  const int64_t samples = int64_t{attempts} * options.samples.count;
  if (samples > kMostSamples)
    throw Error(ErrorCode::too_large,
                fmt::format("{} attempts with {} samples each are {} samples; at most {} are "
                            "possible",
                            attempts, options.samples.count, samples, kMostSamples),
                {}, "use fewer attempts or fewer samples");
  const RandomKey key = RandomKey(options.seed).at("attempts");
  RealisticNetwork best;
  for (int i = 0; i < attempts; ++i) {
    if (i > 0) options.seed = key.at(static_cast<uint64_t>(i)).state();
    RealisticNetwork next{generate(geology, options), {}, options.seed};
    next.realism = network::score(network::measure(next.network));
    if (all_in_bands(next.realism)) return next;
    if (i == 0 || next.realism.overall > best.realism.overall) best = std::move(next);
  }
  return best;
}

}  // namespace vug::karst
