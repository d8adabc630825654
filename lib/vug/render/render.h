// From a scene to a picture.
#pragma once

#include <vug/base/progress.h>
#include <vug/image/image.h>
#include <vug/render/integrator.h>
#include <vug/render/sampler.h>
#include <vug/render/scene.h>

#include <cstdint>

namespace vug::render {

struct Options {
  int width = 960;
  int height = 540;
  int spp = 64;  ///< Samples per pixel; powers of 4 give the sobol sampler its best spread.
  uint64_t seed = 0;
  int threads = 0;      ///< 0: as many as parallel work may use already.
  int max_bounces = 8;  ///< At most this + 1 scatterings; ignored when `integrator` is given.
  int tile = 16;        ///< Pixels on a side of what one task renders; no effect on the picture.
  SamplerPtr sampler;   ///< Null: sobol.
  IntegratorPtr integrator;  ///< Null: path.
};

/// Layers of the picture, 32-bit channels in this order:
///   R G B      radiance, linear Rec.709
///   A          1 where a surface or lamp is seen, 0 where only the sky is
///   Z          distance along the axis of view in metres, mean over the samples that hit a
///              surface; 1e10 where none did
///   N.X N.Y N.Z, P.X P.Y P.Z, albedo.R albedo.G albedo.B
///              normal, position and albedo of the first surface (means as for Z, 0 without)
///   variance.R variance.G variance.B
///              variance of R, G, B: the squared standard error of the pixel's mean, estimated from
///              the spread of its samples as if they were independent. Sobol points err less than
///              that. 0 for a single sample
///   samples    how many samples the means are over
/// The same bytes for any number of threads. Error(bad_input): no camera, sizes or spp below 1,
/// a mesh with indices out of range or positions that are not finite. Error(cancelled).
image::Image render(const Scene& scene, const Options& options,
                    Progress& progress = Progress::none());

/// Bytes that `render` will need beyond the scene itself: acceleration structure and film.
double memory_estimate(const Scene& scene, const Options& options);

}  // namespace vug::render
