// SPDX-License-Identifier: Apache-2.0
// Problems of a picture that a few rays show before it is rendered.
#pragma once

#include <vug/render/prepare.h>
#include <vug/shot/render_settings.h>

#include <string>
#include <vector>

namespace vug::scout {

/// A problem and the setting that solves it.
struct PreflightFinding {
  bool exposure = false;  ///< It concerns the exposure or the light, not the view.
  std::string message, hint;
};

/// Tests a picture of 48 x 27 pixels, which takes less than a second and does not change the
/// render: a view with nothing nearer than 50 m; a picture that is black (99th percentile of the
/// exposed luminance below 0.02) or burnt out (more than 2 % of the surfaces above 8). The light is
/// that of `illuminate`, without haze.
std::vector<PreflightFinding> preflight(const render::PreparedRender& prepared,
                                        const shot::OutputSettings& settings);

}  // namespace vug::scout
