// SPDX-License-Identifier: Apache-2.0
// The parameter `stage`, which selects legs by the zone in which they formed.
#pragma once

#include <vug/base/schema.h>
#include <vug/network/network.h>

#include <optional>

namespace vug::shot {

enum class StageChoice { any, vadose, phreatic, unknown };

/// Adds the parameter for the member `stage` of P.
template <class P>
void describe_stage(Schema<P>& s) {
  s.choice("stage", static_cast<StageChoice P::*>(&P::stage),
           {{"any", StageChoice::any},
            {"vadose", StageChoice::vadose},
            {"phreatic", StageChoice::phreatic},
            {"unknown", StageChoice::unknown}},
           "only where the passage formed above (vadose) or below (phreatic) the water table");
}

inline std::optional<network::Stage> stage_of(StageChoice choice) {
  switch (choice) {
    case StageChoice::vadose:
      return network::Stage::vadose;
    case StageChoice::phreatic:
      return network::Stage::phreatic;
    case StageChoice::unknown:
      return network::Stage::unknown;
    case StageChoice::any:
      break;
  }
  return std::nullopt;
}

}  // namespace vug::shot
