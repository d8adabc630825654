// SPDX-License-Identifier: Apache-2.0
// The transfer function of sRGB (IEC 61966-2-1).
#pragma once

namespace vug {

/// Between linear light and the sRGB encoding, both clamped to [0, 1].
double srgb_encode(double linear);
double srgb_decode(double encoded);

}  // namespace vug
