// SPDX-License-Identifier: Apache-2.0
// Limits outliers before denoising: pixels whose few samples include one of a rare, bright path.
#pragma once

#include <vug/image/denoise_inputs.h>

namespace vug::image {

/// Scales each outlier down to the median of its neighbourhood. The variance of an outlier is about
/// its square, so that nothing distinguishes it from any surroundings: the filter would spread it
/// over its whole window, a bright square. A pixel is an outlier if all of these hold:
///   - it exceeds the upper quartile of the 5 x 5 pixels around it by more than three times the
///     distance of the quartiles, so that clusters of up to five dots are found;
///   - the excess is within 1.5 standard errors of its own variance, so that one or two samples may
///     be all of it: certain highlights stay;
///   - few pixels of the filter's window are about as bright: many are light, and not outliers.
void limit_outliers(DenoiseInputs& inputs);

}  // namespace vug::image
