// SPDX-License-Identifier: Apache-2.0
// Renders the samples of a rectangle of pixels. Samples are independent of each other, so any
// thread may render any of them, with identical results.
#pragma once

#include <vug/base/progress.h>
#include <vug/render/film/film.h>
#include <vug/render/prepare.h>

namespace vug::render {

/// Renders the samples begin <= i < end of each pixel of the tile. Error(cancelled).
Film render_tile(const PreparedRender& prepared, const Region& tile, uint32_t begin, uint32_t end,
                 Progress& progress);

/// Estimates the wall-clock time in seconds of `samples` samples, from a few taken now.
double estimate_seconds(const PreparedRender& prepared, double samples, Progress& progress);

}  // namespace vug::render
