// SPDX-License-Identifier: Apache-2.0
// The noise of the tiles of a picture: marks those that have enough samples, and predicts how many
// samples the others still need.
#pragma once

#include <vug/render/film/noise_report.h>
#include <vug/render/film/render_state.h>

namespace vug::render {

/// Marks each tile whose noise is at most `noise` as converged. The noise of a pixel is the
/// standard error of its luminance, divided by the sum of its luminance and a quarter of the
/// picture's key (the log-average luminance of tiles). So dark corners need no more precision than
/// is visible. The noise of a tile is the root mean square over its own pixels and those of its
/// eight neighbours: a tile that has not sampled its bright paths yet looks converged by itself,
/// and stopping there would darken the picture. No tile converges before kMinAdaptiveSamples. The
/// result depends only on the film. For states of whole pictures.
constexpr uint32_t kMinAdaptiveSamples = 16;
void mark_converged(RenderState& state, double noise);

/// The noise of the picture so far and the samples that the limit `noise` still needs. Depends only
/// on the film, too.
NoiseReport noise_report(const RenderState& state, double noise);

}  // namespace vug::render
