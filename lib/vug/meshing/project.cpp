// SPDX-License-Identifier: Apache-2.0
#include <vug/meshing/project.h>

#include <algorithm>
#include <cmath>

namespace vug::meshing {
namespace {

using field::Dual;
using field::Gradient;
using field::Pack;
using field::Point;

constexpr size_t kLanes = Pack::kLanes;
constexpr size_t kChunk = 16;  // Packs whose points and derivatives stay in the first-level cache.
constexpr size_t kChecksApart = 32;  // Points between those compared with double precision.

SurfacePoint surface_point(const Vec3d& p, const Gradient& g) {
  SurfacePoint here;
  here.point = p;
  const double slope = g.gradient.length();
  if (!(slope > 1e-9) || !std::isfinite(slope)) return here;
  here.normal = g.gradient / slope;
  here.residual = std::fabs(g.value) / slope;
  here.inside = g.value < 0;
  return here;
}

/// The pack that begins at `first`; the last point is repeated for lanes beyond the end.
Point<Pack> pack_at(const std::vector<Vec3d>& points, size_t first) {
  float lanes[3][kLanes];
  for (size_t i = 0; i < kLanes; ++i) {
    const Vec3d& p = points[std::min(first + i, points.size() - 1)];
    for (int axis = 0; axis < 3; ++axis) lanes[axis][i] = static_cast<float>(p[axis]);
  }
  return {Pack::load(lanes[0]), Pack::load(lanes[1]), Pack::load(lanes[2])};
}

}  // namespace

SurfaceProjector::SurfaceProjector(const field::Field& field, const std::vector<Vec3d>& near,
                                   double error)
    : field_(field) {
  std::vector<Vec3d> some;
  double farthest = 0;
  for (size_t i = 0; i < near.size(); ++i) {
    if (i % kChecksApart == 0) some.push_back(near[i]);
    for (int axis = 0; axis < 3; ++axis) farthest = std::max(farthest, std::fabs(near[i][axis]));
  }
  noise_ = farthest * 0x1p-22;
  evaluate_packs(some);
  for (size_t i = 0; i < some.size(); ++i)
    if (!(std::fabs(field.value(some[i]) - gradients_[i].value) <= error)) in_double_ = true;
}

void SurfaceProjector::evaluate_packs(const std::vector<Vec3d>& points) {
  field::Scratch::Frame frame(scratch_);
  auto* packs = frame.take<Point<Pack>>(kChunk);
  auto* slopes = frame.take<Dual<Pack>>(kChunk);
  gradients_.resize(points.size());
  for (size_t begin = 0; begin < points.size(); begin += kChunk * kLanes) {
    const size_t count = std::min(kChunk, (points.size() - begin + kLanes - 1) / kLanes);
    for (size_t i = 0; i < count; ++i) packs[i] = pack_at(points, begin + i * kLanes);
    field_.gradients(packs, static_cast<int>(count), slopes, scratch_);
    for (size_t i = 0; i < count; ++i) {
      float lanes[4][kLanes];
      slopes[i].v.store(lanes[0]);
      slopes[i].dx.store(lanes[1]);
      slopes[i].dy.store(lanes[2]);
      slopes[i].dz.store(lanes[3]);
      const size_t first = begin + i * kLanes;
      for (size_t k = 0; k < kLanes && first + k < points.size(); ++k)
        gradients_[first + k] = {lanes[0][k], Vec3d(Vec3f(lanes[1][k], lanes[2][k], lanes[3][k]))};
    }
  }
}

void SurfaceProjector::evaluate(const std::vector<Vec3d>& points) {
  if (!in_double_) return evaluate_packs(points);
  gradients_.resize(points.size());
  for (size_t i = 0; i < points.size(); ++i) gradients_[i] = field_.gradient(points[i]);
}

std::vector<SurfacePoint> SurfaceProjector::sample(const std::vector<Vec3d>& points) {
  evaluate(points);
  std::vector<SurfacePoint> answers(points.size());
  for (size_t i = 0; i < points.size(); ++i) answers[i] = surface_point(points[i], gradients_[i]);
  return answers;
}

std::vector<SurfacePoint> SurfaceProjector::project(const std::vector<Vec3d>& starts,
                                                    const ProjectOptions& options) {
  const double tolerance = std::max(options.tolerance, resolution());
  const double longest = 0.5 * options.reach;
  std::vector<SurfacePoint> best(starts.size());
  std::vector<Vec3d> at = starts;            // The points still moving,
  std::vector<size_t> which(starts.size());  // and their indices.
  for (size_t i = 0; i < starts.size(); ++i) {
    best[i].point = starts[i];
    which[i] = i;
  }
  for (int step = 0; step <= options.steps && !at.empty(); ++step) {
    evaluate(at);
    size_t left = 0;
    for (size_t k = 0; k < at.size(); ++k) {
      const size_t i = which[k];
      const SurfacePoint here = surface_point(at[k], gradients_[k]);
      if (here.residual < best[i].residual) best[i] = here;
      if (best[i].residual <= tolerance || here.normal == Vec3d(0)) continue;
      const double length = std::min(here.residual, longest);
      const Vec3d next = at[k] - here.normal * std::copysign(length, gradients_[k].value);
      if ((next - starts[i]).length() > options.reach) continue;
      at[left] = next;
      which[left++] = i;
    }
    at.resize(left);
    which.resize(left);
  }
  return best;
}

}  // namespace vug::meshing
