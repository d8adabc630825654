// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/render/geometry/require_static.h>
#include <vug/render/lighting/emitters.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::render {

struct Emitters::WorldTriangle {
  Vec3f a, b, c;
  Vec3f normal;  ///< Unit; zero for a triangle without area.
  float area;
  float orientation;  ///< -1 if the instance mirrors the triangle and so makes it clockwise.

  Vec3f centroid() const { return (a + b + c) * (1 / 3.0f); }
  /// Beyond the distance at which 1 / distance^2 varies by about a quarter over the triangle.
  bool is_far(const Vec3f& point) const {
    const Vec3f m = centroid(), to = m - point;
    const auto squared = [&](const Vec3f& p) { return dot(p - m, p - m); };
    return dot(to, to) > 256 * std::max(squared(a), std::max(squared(b), squared(c)));
  }
  bool faces(const Vec3f& point) const { return dot(normal, point - a) > 0; }
};

namespace {

/// A triangle as seen from a point; names as in the paper.
struct SphericalTriangle {
  Vec3d a, b, c;
  double area = 0, alpha = 0;

  SphericalTriangle(const Vec3f& from, const Vec3f& pa, const Vec3f& pb, const Vec3f& pc)
      : a(Vec3d(pa - from).normalized()),
        b(Vec3d(pb - from).normalized()),
        c(Vec3d(pc - from).normalized()) {
    // Van Oosterom and Strackee 1983, "The solid angle of a plane triangle".
    const double volume = std::fabs(a.dot(b.cross(c)));
    area = 2 * maths::atan2(volume, 1 + a.dot(b) + b.dot(c) + c.dot(a));
    const Vec3d ab = a.cross(b), ac = a.cross(c);
    alpha = maths::atan2(ab.cross(ac).length(), ab.dot(ac));
  }
  /// False for a sliver too thin for the difference of angles to be meaningful.
  bool usable() const { return area > 1e-7 && area < 6.2 && alpha > 1e-5 && alpha < kPi - 1e-5; }

  Vec3d sample(const Vec2f& u) const {
    const double phi = static_cast<double>(u.x) * area - alpha;
    const double s = maths::sin(phi), t = maths::cos(phi);
    const double cos_alpha = maths::cos(alpha), sin_alpha = maths::sin(alpha);
    const double v1 = t - cos_alpha, v2 = s + sin_alpha * a.dot(b);
    const double q = ((v2 * t - v1 * s) * cos_alpha - v2) / ((v2 * s + v1 * t) * sin_alpha);
    const auto towards = [](const Vec3d& x, const Vec3d& axis, double cosine) {
      const double clamped = std::isfinite(cosine) ? std::clamp(cosine, -1.0, 1.0) : 1;
      const Vec3d aside = x - axis * x.dot(axis);
      return axis * clamped +
             aside * (std::sqrt(1 - clamped * clamped) / std::max(aside.length(), 1e-30));
    };
    const Vec3d corner = towards(c, a, q);
    return towards(corner, b, 1 - static_cast<double>(u.y) * (1 - corner.dot(b)));
  }
};

/// Uniform point on a triangle as the barycentric coordinates of its second and third vertex: Heitz
/// 2019, "A low-distortion map between triangle and square".
Vec2f on_triangle(const Vec2f& u) {
  return u.y > u.x ? Vec2f(0.5f * u.x, u.y - 0.5f * u.x) : Vec2f(u.x - 0.5f * u.y, 0.5f * u.y);
}

}  // namespace

Emitters::Emitters(const std::vector<Object>& objects) : first_(objects.size(), kNone) {
  for (size_t i = 0; i < objects.size(); ++i) {
    const Object& object = objects[i];
    const bool varies = object.material && object.material->is_emissive();
    if (object.material && object.material->cut_out() && (varies || !is_black(object.emission)))
      throw Error(ErrorCode::bad_input,
                  fmt::format("object '{}' is emissive and has holes by its material's opacity, "
                              "which cannot be rendered",
                              object.name),
                  {}, "split it into two objects, or use emission_mask");
    if (object.surface && (varies || !is_black(object.emission)))
      throw Error(
          ErrorCode::bad_input,
          fmt::format("object '{}' is emissive, but has no mesh whose triangles could be lights",
                      object.name),
          {}, "leave out 'direct'");
    if (!object.mesh || object.mesh->triangles.empty() || (is_black(object.emission) && !varies))
      continue;
    if (count_ + object.mesh->triangles.size() > (1u << 28))
      throw Error(ErrorCode::too_large,
                  fmt::format("object '{}' brings the number of emissive triangles to more than {}",
                              object.name, 1u << 28));
    require_static(object);
    first_[i] = static_cast<uint32_t>(count_);
    sources_.push_back({object.mesh, object.emission, static_cast<uint32_t>(i),
                        static_cast<uint32_t>(count_), object.instance,
                        object.world_space_material});
    count_ += object.mesh->triangles.size();
    if (!varies) continue;
    EmissiveMesh& source = sources_.back();
    source.material = object.material, source.solid = object.solid, source.flat = object.flat;
    emission_varies_ = true;
    estimate_luminances(source);
  }
}

const Emitters::EmissiveMesh& Emitters::emissive_mesh(uint32_t index) const {
  const auto next = std::upper_bound(
      sources_.begin(), sources_.end(), index,
      [](uint32_t value, const EmissiveMesh& source) { return value < source.first; });
  return *(next - 1);
}

Emitters::WorldTriangle Emitters::world_triangle(uint32_t index) const {
  const EmissiveMesh& source = emissive_mesh(index);
  const mesh::Triangle& t = source.mesh->triangles[index - source.first];
  const auto& p = source.mesh->positions;
  WorldTriangle out{p[t[0]], p[t[1]], p[t[2]], Vec3f(0.0f), 0, 1};
  if (source.instance) {
    const Affine place = source.instance->at(0);
    out.a = place.point(out.a), out.b = place.point(out.b), out.c = place.point(out.c);
    out.orientation = place.determinant() < 0 ? -1.0f : 1.0f;
  }
  const Vec3f n = cross(out.b - out.a, out.c - out.a) * out.orientation;
  const float size = length(n);
  if (size > 0) out.normal = n * (1 / size);
  out.area = 0.5f * size;
  return out;
}

Rgb Emitters::radiance(uint32_t index, float u, float v, float footprint) const {
  if (index >= count_) return Rgb(0.0f);
  const EmissiveMesh& source = emissive_mesh(index);
  return radiance_at(source, index - source.first, u, v, footprint);
}

Rgb Emitters::radiance_at(const EmissiveMesh& source, uint32_t triangle, float u, float v,
                          float footprint) const {
  if (!source.material) return source.radiance;
  const mesh::Mesh& mesh = *source.mesh;
  const mesh::Triangle& corner = mesh.triangles[triangle];
  const auto& p = mesh.positions;
  const Vec3f a = p[corner[0]], ab = p[corner[1]] - a, ac = p[corner[2]] - a, n = cross(ab, ac);
  const float size = length(n), w = 1 - u - v;
  if (!(size > 0)) return Rgb(0.0f);
  Surface surface;
  surface.position = a + ab * u + ac * v;
  surface.geometric_normal = surface.shading_normal = n * (1 / size);
  if (!source.flat && !mesh.normals.empty()) {
    const Vec3f smooth =
        mesh.normals[corner[0]] * w + mesh.normals[corner[1]] * u + mesh.normals[corner[2]] * v;
    if (const float norm = length(smooth); norm > 0) surface.shading_normal = smooth * (1 / norm);
  }
  surface.footprint = footprint;
  surface.mesh = &mesh, surface.triangle = triangle, surface.u = u, surface.v = v;
  surface.solid = source.solid.get();
  if (source.instance) {
    const Affine place = source.instance->at(0);
    surface.position = place.point(surface.position);
    surface.geometric_normal = normalized(place.normal(surface.geometric_normal));
    surface.shading_normal = normalized(place.normal(surface.shading_normal));
    surface.instance = source.instance.get();
    surface.world_space_material = source.world_space_material;
  }
  return source.radiance + source.material->emission(surface);
}

/// Means over a low-discrepancy sequence of points on each triangle (Roberts 2018, "The
/// unreasonable effectiveness of quasirandom sequences", cite roberts2018sequences); meshes of few
/// triangles get more points.
void Emitters::estimate_luminances(EmissiveMesh& source) const {
  constexpr size_t kAll = 1u << 22, kFewest = 3, kMax = 64;
  const size_t count = source.mesh->triangles.size();
  const size_t places = std::clamp(kAll / count, kFewest, kMax);
  source.luminances.resize(count);
  parallel_for(
      count,
      [&](size_t i) {
        const auto triangle = static_cast<uint32_t>(i);
        const WorldTriangle t = world_triangle(source.first + triangle);
        const float apart = std::sqrt(t.area / static_cast<float>(places));
        float sum = 0;
        for (size_t k = 0; k < places; ++k) {
          const auto step = static_cast<double>(k) + 0.5;
          const double x = step * 0.7548776662466927, y = step * 0.5698402909980532;
          const Vec2f at = on_triangle(
              {static_cast<float>(x - std::floor(x)), static_cast<float>(y - std::floor(y))});
          sum += luminance(radiance_at(source, triangle, at.x, at.y, apart));
        }
        source.luminances[i] = sum / static_cast<float>(places);
      },
      256);
}

LightBounds Emitters::bounds(uint32_t index) const {
  const WorldTriangle t = world_triangle(index);
  LightBounds out;
  out.box = Box3f(t.a);
  out.box.extendBy(t.b);
  out.box.extendBy(t.c);
  out.axis = t.normal;
  out.cos_spread = 1;
  out.cos_reach = 0;
  const EmissiveMesh& source = emissive_mesh(index);
  out.strength =
      (source.material ? source.luminances[index - source.first] : luminance(source.radiance)) *
      t.area;
  return out;
}

Vec3f Emitters::center(uint32_t index) const { return world_triangle(index).centroid(); }

LightSample Emitters::sample(uint32_t index, const LightSampleContext& point,
                             const Vec2f& u) const {
  LightSample s;
  const WorldTriangle t = world_triangle(index);
  if (!t.faces(point.position)) return s;
  const EmissiveMesh& source = emissive_mesh(index);
  s.radiance = source.radiance;
  if (!t.is_far(point.position)) {
    const SphericalTriangle seen(point.position, t.a, t.b, t.c);
    if (seen.usable()) {
      s.direction = Vec3f(seen.sample(u));
      const float facing = -dot(s.direction, t.normal);
      if (!(facing > 0)) return s;
      s.distance = dot(t.normal, point.position - t.a) / facing;
      s.pdf = static_cast<float>(1 / seen.area);
      if (source.material) {
        const Vec3f on = point.position + s.direction * s.distance - t.a;
        const float twice = 2 * t.area * t.orientation;
        const float x = std::clamp(dot(cross(on, t.c - t.a), t.normal) / twice, 0.0f, 1.0f);
        const float y = std::clamp(dot(cross(t.b - t.a, on), t.normal) / twice, 0.0f, 1 - x);
        s.radiance = radiance_at(source, index - source.first, x, y, 0);
      }
      return s;
    }
  }
  const Vec2f at = on_triangle(u);
  if (source.material) s.radiance = radiance_at(source, index - source.first, at.x, at.y, 0);
  const Vec3f to = t.a + (t.b - t.a) * at.x + (t.c - t.a) * at.y - point.position;
  const float squared = dot(to, to);
  s.distance = std::sqrt(squared);
  if (!(s.distance > 0)) return s;
  s.direction = to * (1 / s.distance);
  const float facing = -dot(s.direction, t.normal);
  s.pdf = facing > 0 ? squared / (t.area * facing) : 0;
  return s;
}

float Emitters::pdf(uint32_t index, const LightSampleContext& point, const Vec3f& direction) const {
  const WorldTriangle t = world_triangle(index);
  const float facing = -dot(direction, t.normal);
  if (!(facing > 0) || !t.faces(point.position)) return 0;
  if (!t.is_far(point.position)) {
    const SphericalTriangle seen(point.position, t.a, t.b, t.c);
    if (seen.usable()) return static_cast<float>(1 / seen.area);
  }
  const float distance = dot(t.normal, point.position - t.a) / facing;
  return distance * distance / (t.area * facing);
}

}  // namespace vug::render
