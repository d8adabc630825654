// SPDX-License-Identifier: Apache-2.0
// Surfaces of level sets without a mesh: Embree finds the bricks, and the bricks the crossing.
#include <vug/render/geometry/embree.h>
#include <vug/render/geometry/grid_surface.h>

#include <algorithm>
#include <cmath>

namespace vug::render {
namespace {

std::optional<Crossing> crossing(const void* surface, uint32_t brick, const RTCRay& ray) {
  return first_crossing(*static_cast<const volume::SurfaceBricks*>(surface), brick,
                        Vec3d(Vec3f(ray.org_x, ray.org_y, ray.org_z)),
                        Vec3d(Vec3f(ray.dir_x, ray.dir_y, ray.dir_z)),
                        static_cast<double>(ray.tnear), static_cast<double>(ray.tfar));
}

/// Slightly larger than the brick, because boxes are in single precision.
void bounds_of(const RTCBoundsFunctionArguments* args) {
  const auto& surface = *static_cast<const volume::SurfaceBricks*>(args->geometryUserPtr);
  const Box3d box = surface.box(args->primID);
  const auto below = [&](double x) {
    return std::nextafterf(static_cast<float>(x - 1e-3 * surface.voxel()), -kFar);
  };
  const auto above = [&](double x) {
    return std::nextafterf(static_cast<float>(x + 1e-3 * surface.voxel()), kFar);
  };
  RTCBounds& out = *args->bounds_o;
  out.lower_x = below(box.min.x), out.upper_x = above(box.max.x);
  out.lower_y = below(box.min.y), out.upper_y = above(box.max.y);
  out.lower_z = below(box.min.z), out.upper_z = above(box.max.z);
}

template <class RayContext>
void intersect_brick(const RTCIntersectFunctionNArguments* args) {
  if (args->valid[0] == 0) return;
  auto& query = *reinterpret_cast<RTCRayHit*>(args->rayhit);  // rays come one at a time
  const auto met = crossing(args->geometryUserPtr, args->primID, query.ray);
  if (!met) return;
  query.ray.tfar = static_cast<float>(met->t);
  query.hit.geomID = args->geomID, query.hit.primID = args->primID;
  query.hit.instID[0] = args->context->instID[0];
  static_cast<RayContext*>(args->context)->crossing = *met;
}

void occlude_brick(const RTCOccludedFunctionNArguments* args) {
  if (args->valid[0] == 0) return;
  auto& ray = *reinterpret_cast<RTCRay*>(args->ray);
  if (crossing(args->geometryUserPtr, args->primID, ray)) ray.tfar = -kFar;
}

/// Transforms between world space and the space of the level set, for instances and other objects.
struct Space {
  const InstanceTransform* instance;
  Transform to_own;
  Affine to;

  Space(const InstanceTransform* p, float time) : instance(p) {
    if (p) to_own = p->inverse(time), to = p->at(time);
  }
  Vec3d point(const Vec3d& p) const { return instance ? to_own.point(p) : p; }
  Vec3d vector(const Vec3d& v) const { return instance ? to_own.vector(v) : v; }
  Vec3d back(const Vec3d& v) const { return instance ? Vec3d(to.vector(Vec3f(v))) : v; }
  /// Unit length, in world space.
  Vec3f normal(const Vec3d& n) const {
    const Vec3d unit = n.normalized();
    return instance ? normalized(to.normal(Vec3f(unit))) : Vec3f(unit);
  }
  float extent(float size) const {
    return instance ? (size + instance->origin_extent()) * instance->error_scale() : size;
  }
};

/// Constructs a crossing at `t` when the exact one is missed.
Crossing crossing_near(const volume::SurfaceBricks& surface, size_t number, const Vec3d& origin,
                       const Vec3d& direction, double t) {
  const volume::SurfaceBricks::Brick& brick = surface.bricks()[number];
  const Vec3d own = origin + direction * t, at = surface.to_lattice(own);
  Crossing out{t, {}, false};
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<size_t>(axis);
    out.cell[a] = std::clamp(static_cast<int>(std::floor(at[axis])), brick.first[a] + brick.low[a],
                             brick.first[a] + brick.high[a] - 1);
  }
  out.outwards = trilinear(surface, number, out.cell, own).gradient.dot(direction) > 0;
  return out;
}

float largest_coordinate(const Vec3f& p) {
  return std::max(std::fabs(p.x), std::max(std::fabs(p.y), std::fabs(p.z)));
}

}  // namespace

void PreparedScene::Geometry::Embree::add_surface(RTCScene to, const volume::SurfaceBricks& surface,
                                                  size_t number) const {
  RTCGeometry geometry = rtcNewGeometry(device_->get(), RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(surface.bricks().size()));
  rtcSetGeometryUserData(geometry, const_cast<volume::SurfaceBricks*>(&surface));
  rtcSetGeometryBoundsFunction(geometry, bounds_of, nullptr);
  rtcSetGeometryIntersectFunction(geometry, intersect_brick<RayContext>);
  rtcSetGeometryOccludedFunction(geometry, occlude_brick);
  attach(to, geometry, number);
  device_->check("adding a level set");
}

void PreparedScene::Geometry::fill_surface(const TracedObject& traced, uint32_t brick,
                                           const Crossing& seen, float time, const Ray& ray,
                                           Hit& hit) {
  const volume::SurfaceBricks& grid = *traced.surface;
  const Space space(traced.instance.get(), time);
  const Vec3d from = space.point(Vec3d(ray.origin)), direction = space.vector(Vec3d(ray.direction));
  Crossing met = seen;
  // The ray of an instance is transformed by Embree, whose last bits depend on the machine. The
  // crossing is recomputed, so that it is the same everywhere; it may just miss here.
  if (traced.instance) {
    const auto again = first_crossing(grid, brick, from, direction, 0, kInfinity);
    met = again ? *again : crossing_near(grid, brick, from, direction, seen.t);
  }
  const Vec3d own = from + direction * met.t;
  const GridValue sharp = trilinear(grid, brick, met.cell, own);
  const GridValue soft = smooth(grid, brick, met.cell, own);
  const float side = met.outwards ? -1.0f : 1.0f;

  Surface& surface = hit.surface;
  surface.position = Vec3f(Vec3d(ray.origin) + Vec3d(ray.direction) * met.t);
  hit.distance = static_cast<float>(met.t);
  hit.material = traced.material.get();
  hit.object = traced.scene_index;
  hit.triangle = brick;
  hit.emission = Rgb(0.0f);
  surface.inside = met.outwards;
  surface.mesh = nullptr;
  surface.solid = traced.solid.get();
  surface.geometric_normal = -ray.direction;
  if (sharp.gradient.length2() > 0) surface.geometric_normal = space.normal(sharp.gradient) * side;
  const bool is_smooth = !traced.flat && soft.gradient.length2() > 0;
  const Vec3f smooth_normal =
      is_smooth ? space.normal(soft.gradient) * side : surface.geometric_normal;
  surface.shading_normal = smooth_normal;
  surface.face(ray.direction);

  const float size = space.extent(largest_coordinate(surface.position));
  const auto value = [&](const Vec3f& at) {
    return static_cast<float>(trilinear_value(grid, brick, space.point(Vec3d(at))));
  };
  // Offset from the surface by the rounding error, and further until the point really is on its
  // side by that much: in a sharp valley the other wall is near, and the smooth normal avoids both.
  const auto shrink = static_cast<float>(space.vector(Vec3d(surface.geometric_normal)).length());
  const auto clear = [&](const Vec3f& from_here, float to) {
    const float enough =
        0.25f * shrink * length(offset_point(Vec3f(0.0f), surface.geometric_normal, size));
    Vec3f best = from_here;
    float most = -kFar, reach = size;
    for (int more = 0; more < 6 && !(most > enough); ++more, reach *= 2) {
      const Vec3f& normal = more % 2 ? smooth_normal : surface.geometric_normal;
      const Vec3f at = offset_point(from_here, normal * to, reach);
      if (const float here = value(at) * side * to; here > most) best = at, most = here;
    }
    return best;
  };
  // Lift to the smooth surface where that is nearer to the viewer: cells are flat along their axes,
  // and their edges would cast shadows under grazing light.
  Vec3f origin = surface.position;
  const double depth = -soft.value * static_cast<double>(side);
  if (is_smooth && depth > 0) {
    const double height = std::min(depth / soft.gradient.length(), 0.5 * grid.voxel());
    const Vec3d up = soft.gradient.normalized() * (height * static_cast<double>(side));
    const auto is_clear = [&](double t) {
      return trilinear_value(grid, brick, own + up * t) * static_cast<double>(side) > 0;
    };
    if (is_clear(0.5) && is_clear(1)) origin += Vec3f(space.back(up));
  }
  hit.origin = clear(origin, 1);
  hit.behind = clear(surface.position, -1);
  surface.color = Rgb(1.0f);
  if (traced.color) {
    const Vec3d out = (soft.gradient.length2() > 0 ? soft.gradient : sharp.gradient).normalized();
    const Vec3d color = (*traced.color)({own, out, traced.solid.get()});
    for (int c = 0; c < 3; ++c)
      surface.color[c] = static_cast<float>(std::min(1.0, std::max(0.0, color[c])));
  }
}

}  // namespace vug::render
