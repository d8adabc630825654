#include <vug/meshing/project.h>

#include <cmath>

namespace vug::meshing {
namespace {

struct Step {
  SurfacePoint here;
  Vec3d newton{0, 0, 0};  ///< To the zero of the tangent.
};

Step step_at(const field::Field& field, const Vec3d& p) {
  const field::Gradient g = field.gradient(p);
  const double slope = g.gradient.length();
  Step step;
  step.here.point = p;
  if (!(slope > 1e-9) || !std::isfinite(slope)) return step;
  step.here.normal = g.gradient / slope;
  step.here.residual = std::fabs(g.value) / slope;
  step.newton = step.here.normal * (-g.value / slope);
  return step;
}

}  // namespace

SurfacePoint probe(const field::Field& field, const Vec3d& p) { return step_at(field, p).here; }

SurfacePoint project(const field::Field& field, const Vec3d& start, const ProjectOptions& options) {
  SurfacePoint best;
  best.point = start;
  Vec3d p = start;
  for (int i = 0; i <= options.steps; ++i) {
    const Step step = step_at(field, p);
    if (step.here.residual < best.residual) best = step.here;
    if (best.residual <= options.tolerance || step.newton == Vec3d(0)) break;
    const double length = step.newton.length();
    const double longest = 0.5 * options.reach;
    p += length > longest ? step.newton * (longest / length) : step.newton;
    if ((p - start).length() > options.reach) break;
  }
  return best;
}

}  // namespace vug::meshing
