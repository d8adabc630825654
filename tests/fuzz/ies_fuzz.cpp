// SPDX-License-Identifier: Apache-2.0
// For any bytes, the IES reader returns a profile whose intensities are finite and do not exceed
// its peak, or fails with bad_input.
#include "target.h"

#include <vug/base/error.h>
#include <vug/render/lighting/ies_profile.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

VUG_FUZZ_TARGET(ies) {
  try {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const vug::render::IesProfile profile(text, "fuzz.ies");
    for (int down = -4; down <= 4; ++down)
      for (int turn = 0; turn < 8; ++turn) {
        const float light =
            profile.candela(static_cast<float>(down) / 4, static_cast<float>(turn) / 8);
        if (!(light >= 0 && light <= profile.peak() * 1.0001f)) std::abort();
      }
    if (!(profile.lumen() >= 0 && std::isfinite(profile.lumen()))) std::abort();
  } catch (const vug::Error& error) {
    if (error.code() != vug::ErrorCode::bad_input) std::abort();
    if (std::string(error.what()).find("fuzz.ies") == std::string::npos) std::abort();
  }
}
