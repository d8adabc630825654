// Where a picture has samples enough.
#pragma once

#include <vug/render/film/render_state.h>

namespace vug::render {

/// Marks as converged each block whose noise is at most `noise`. The noise of a pixel is its
/// standard error of luminance over its luminance plus a quarter of the picture's key (the
/// log-average luminance of blocks): a relative error that asks for no more in black corners than
/// the eye sees. That of a block is the root mean square over its pixels and those of its eight
/// neighbours: a block that has not met its bright paths yet looks calm by itself, and to stop
/// there would darken the picture. Nothing settles before kMinAdaptiveSamples. Depends on the film
/// alone; for states of whole pictures.
constexpr uint32_t kMinAdaptiveSamples = 16;
void mark_converged(RenderState& state, double noise);

}  // namespace vug::render
