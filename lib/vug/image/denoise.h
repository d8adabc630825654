// A smoother picture out of a noisy one and its layers, for previews.
#pragma once

#include <vug/base/progress.h>
#include <vug/image/image.h>

namespace vug::image {

struct DenoiseOptions {
  int window = 8;         ///< Pixels on each side whose values may be borrowed.
  int patch = 2;          ///< Pixels on each side that are compared.
  double strength = 0.6;  ///< Differences below this many standard errors count as noise.
};

/// Means of R, G, B over pixels that look alike: non-local means weighed by the colour's distance
/// in units of its variance and, jointly, by albedo, normal and depth (Rousselle, Manzi and Zwicker
/// 2013, "Robust denoising using feature and color information", cite rousselle2013denoising). We
/// differ in one scale instead of three candidates, in filtering light without the albedo where
/// there is one, and in a polynomial in place of the exponential. The picture needs R, G, B and
/// variance.R .G .B, and uses albedo, N and Z when they are there. Biased: it smooths what the
/// layers do not tell apart, such as the edges of soft shadows. Error(bad_input) when a needed
/// channel is missing. The result has the channels denoised.R, denoised.G, denoised.B. Same bytes
/// for any threads.
Image denoise(const Image& picture, const DenoiseOptions& options = {},
              Progress& progress = Progress::none());

}  // namespace vug::image
