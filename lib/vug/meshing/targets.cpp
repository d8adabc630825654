#include <vug/base/maths.h>
#include <vug/meshing/blocks.h>
#include <vug/meshing/crease.h>
#include <vug/meshing/targets.h>

#include <algorithm>
#include <cmath>

namespace vug::meshing {
namespace {

constexpr double kBlock = 8;          ///< Edge of a block of points, voxels.
constexpr double kTolerance = 1e-5;   ///< Residual at which a projection is done, voxels.
constexpr double kGoodSample = 0.02;  ///< Samples further from the surface are not used, voxels.
constexpr double kBeyondCell = 0.5;   ///< How far a crease may lie outside its cell, voxels.
constexpr int kRefinements = 2;
constexpr double kShrink = 0.2;  ///< Of the samples' distances, for curved creases.

class Finder {
 public:
  Finder(const FaceMesh& raw, double voxel, const PolygonizeOptions& options)
      : raw_(raw),
        voxel_(voxel),
        options_(options),
        crease_cosine_(maths::cos(options.crease_angle * kPi / 180)),
        reach_{options.max_move * voxel, kTolerance * voxel, 10} {}

  BlockOptions blocks() const { return {kBlock * voxel_, (2 * options_.max_move + 1) * voxel_}; }

  /// The surface near the middle of each face, with its normal there.
  void sample_faces(const field::Field& exact, Progress& progress) {
    std::vector<Vec3d> centres(raw_.faces.size());
    for (size_t f = 0; f < centres.size(); ++f) centres[f] = raw_.centre(raw_.faces[f]);
    samples_.resize(centres.size());
    for_each_in_blocks(
        exact, centres, blocks(),
        [&](uint32_t f, const field::Field& local) {
          samples_[f] = project(local, centres[f], reach_);
        },
        progress);
  }

  Target target(uint32_t v, const field::Field& local) const {
    Target target;
    target.surface = project(local, raw_.points[v], reach_).point;
    if (!options_.creases) return target;
    std::vector<SurfacePoint> samples;
    for (uint32_t i = raw_.first[v]; i < raw_.first[v + 1]; ++i)
      if (samples_[raw_.around[i]].residual <= kGoodSample * voxel_)
        samples.push_back(samples_[raw_.around[i]]);
    if (samples.size() < 2 || least_agreement(samples) > crease_cosine_) return target;
    Vec3d middle(0);
    for (const SurfacePoint& s : samples) middle += s.point / static_cast<double>(samples.size());
    target.crease = on_crease(v, local, samples, raw_.points[v]);
    target.elsewhere = on_crease(v, local, samples, middle);
    target.has_crease = true;
    return target;
  }

 private:
  Vec3d on_crease(uint32_t v, const field::Field& local, std::vector<SurfacePoint> samples,
                  const Vec3d& anchor) const {
    Vec3d x = clamped(v, fit_planes(samples, anchor));
    for (int i = 0; i < kRefinements; ++i) {
      for (SurfacePoint& s : samples) s = project(local, x + (s.point - x) * kShrink, reach_);
      x = clamped(v, fit_planes(samples, anchor));
    }
    const ProjectOptions close{0.25 * voxel_, kTolerance * voxel_, 10};
    return project(local, x, close).point;
  }

  /// x kept within half a voxel of the vertex's cell and within reach of the vertex.
  Vec3d clamped(uint32_t v, Vec3d x) const {
    const Vec3d& from = raw_.points[v];
    for (int axis = 0; axis < 3; ++axis) {
      const double cell = std::floor(from[axis] / voxel_);
      x[axis] =
          std::clamp(x[axis], (cell - kBeyondCell) * voxel_, (cell + 1 + kBeyondCell) * voxel_);
    }
    const double length = (x - from).length();
    return length > reach_.reach ? from + (x - from) * (reach_.reach / length) : x;
  }

  const FaceMesh& raw_;
  double voxel_;
  const PolygonizeOptions& options_;
  double crease_cosine_;
  ProjectOptions reach_;
  std::vector<SurfacePoint> samples_;  ///< By face.
};

}  // namespace

std::vector<Target> find_targets(const FaceMesh& raw, const field::Field& exact, double voxel,
                                 const PolygonizeOptions& options, Progress& progress) {
  Finder finder(raw, voxel, options);
  if (options.creases) finder.sample_faces(exact, progress);
  std::vector<Target> targets(raw.points.size());
  for_each_in_blocks(
      exact, raw.points, finder.blocks(),
      [&](uint32_t v, const field::Field& local) { targets[v] = finder.target(v, local); },
      progress);
  return targets;
}

}  // namespace vug::meshing
