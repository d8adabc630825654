#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/render/lighting/emitters.h>
#include <vug/render/geometry/require_static.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::render {

struct Emitters::Corners {
  Vec3f a, b, c;
  Vec3f normal;  ///< Unit; zero for a triangle without area.
  float area;
  float turn;  ///< -1 where an instance mirrors the triangle, which runs clockwise then.

  Vec3f middle() const { return (a + b + c) * (1 / 3.0f); }
  /// The distance at which 1 / distance^2 varies by about a quarter over the triangle.
  bool is_far(const Vec3f& point) const {
    const Vec3f m = middle(), to = m - point;
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
  /// Else too thin a sliver for the difference of angles to mean anything.
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

/// Uniform over a triangle, as shares of the second and third corner: Heitz 2019, "A low-distortion
/// map between triangle and square".
Vec2f on_triangle(const Vec2f& u) {
  return u.y > u.x ? Vec2f(0.5f * u.x, u.y - 0.5f * u.x) : Vec2f(u.x - 0.5f * u.y, 0.5f * u.y);
}

}  // namespace

Emitters::Emitters(const std::vector<Object>& objects) : first_(objects.size(), kNone) {
  for (size_t i = 0; i < objects.size(); ++i) {
    const Object& object = objects[i];
    const bool varies = object.material && object.material->shines();
    if (object.material && object.material->cut_out() && (varies || !is_black(object.emission)))
      throw Error(ErrorCode::bad_input,
                  fmt::format("object '{}' shines and has holes by its material's opacity, which "
                              "cannot be rendered",
                              object.name),
                  {}, "make it of two objects, or use emission_mask");
    if (object.surface && (varies || !is_black(object.emission)))
      throw Error(ErrorCode::bad_input,
                  fmt::format("object '{}' shines, but has no mesh whose triangles could be lamps",
                              object.name),
                  {}, "leave out 'direct'");
    if (!object.mesh || object.mesh->triangles.empty() || (is_black(object.emission) && !varies))
      continue;
    if (count_ + object.mesh->triangles.size() > (1u << 28))
      throw Error(ErrorCode::too_large,
                  fmt::format("object '{}' brings the triangles that shine to more than {}",
                              object.name, 1u << 28));
    require_still(object);
    first_[i] = static_cast<uint32_t>(count_);
    parts_.push_back({object.mesh, object.emission, static_cast<uint32_t>(i),
                      static_cast<uint32_t>(count_), object.placing, object.looks_by_place});
    count_ += object.mesh->triangles.size();
    if (!varies) continue;
    Part& part = parts_.back();
    part.material = object.material, part.solid = object.solid, part.flat = object.flat;
    vary_ = true;
    estimate(part);
  }
}

const Emitters::Part& Emitters::part_of(uint32_t number) const {
  const auto next =
      std::upper_bound(parts_.begin(), parts_.end(), number,
                       [](uint32_t value, const Part& part) { return value < part.first; });
  return *(next - 1);
}

Emitters::Corners Emitters::corners(uint32_t number) const {
  const Part& part = part_of(number);
  const mesh::Triangle& t = part.mesh->triangles[number - part.first];
  const auto& p = part.mesh->positions;
  Corners out{p[t[0]], p[t[1]], p[t[2]], Vec3f(0.0f), 0, 1};
  if (part.placing) {
    const Affine place = part.placing->at(0);
    out.a = place.point(out.a), out.b = place.point(out.b), out.c = place.point(out.c);
    out.turn = place.determinant() < 0 ? -1.0f : 1.0f;
  }
  const Vec3f n = cross(out.b - out.a, out.c - out.a) * out.turn;
  const float size = length(n);
  if (size > 0) out.normal = n * (1 / size);
  out.area = 0.5f * size;
  return out;
}

Rgb Emitters::radiance(uint32_t number, float u, float v, float footprint) const {
  if (number >= count_) return Rgb(0.0f);
  const Part& part = part_of(number);
  return radiance_at(part, number - part.first, u, v, footprint);
}

Rgb Emitters::radiance_at(const Part& part, uint32_t triangle, float u, float v,
                          float footprint) const {
  if (!part.material) return part.radiance;
  const mesh::Mesh& mesh = *part.mesh;
  const mesh::Triangle& corner = mesh.triangles[triangle];
  const auto& p = mesh.positions;
  const Vec3f a = p[corner[0]], ab = p[corner[1]] - a, ac = p[corner[2]] - a, n = cross(ab, ac);
  const float size = length(n), w = 1 - u - v;
  if (!(size > 0)) return Rgb(0.0f);
  Surface surface;
  surface.position = a + ab * u + ac * v;
  surface.geometric_normal = surface.shading_normal = n * (1 / size);
  if (!part.flat && !mesh.normals.empty()) {
    const Vec3f smooth =
        mesh.normals[corner[0]] * w + mesh.normals[corner[1]] * u + mesh.normals[corner[2]] * v;
    if (const float norm = length(smooth); norm > 0) surface.shading_normal = smooth * (1 / norm);
  }
  surface.footprint = footprint;
  surface.mesh = &mesh, surface.triangle = triangle, surface.u = u, surface.v = v;
  surface.solid = part.solid.get();
  if (part.placing) {
    const Affine place = part.placing->at(0);
    surface.position = place.point(surface.position);
    surface.geometric_normal = normalized(place.normal(surface.geometric_normal));
    surface.shading_normal = normalized(place.normal(surface.shading_normal));
    surface.placing = part.placing.get();
    surface.looks_by_place = part.looks_by_place;
  }
  return part.radiance + part.material->emission(surface);
}

/// Means over places that fill the triangle evenly (Roberts 2018, "The unreasonable effectiveness
/// of quasirandom sequences", cite roberts2018sequences): more where triangles are few.
void Emitters::estimate(Part& part) const {
  constexpr size_t kAll = 1u << 22, kFewest = 3, kMost = 64;
  const size_t count = part.mesh->triangles.size();
  const size_t places = std::clamp(kAll / count, kFewest, kMost);
  part.luminances.resize(count);
  parallel_for(
      count,
      [&](size_t i) {
        const auto triangle = static_cast<uint32_t>(i);
        const Corners t = corners(part.first + triangle);
        const float apart = std::sqrt(t.area / static_cast<float>(places));
        float sum = 0;
        for (size_t k = 0; k < places; ++k) {
          const auto step = static_cast<double>(k) + 0.5;
          const double x = step * 0.7548776662466927, y = step * 0.5698402909980532;
          const Vec2f at = on_triangle(
              {static_cast<float>(x - std::floor(x)), static_cast<float>(y - std::floor(y))});
          sum += luminance(radiance_at(part, triangle, at.x, at.y, apart));
        }
        part.luminances[i] = sum / static_cast<float>(places);
      },
      256);
}

LightBounds Emitters::bounds(uint32_t number) const {
  const Corners t = corners(number);
  LightBounds out;
  out.box = Box3f(t.a);
  out.box.extendBy(t.b);
  out.box.extendBy(t.c);
  out.axis = t.normal;
  out.cos_spread = 1;
  out.cos_reach = 0;
  const Part& part = part_of(number);
  out.strength =
      (part.material ? part.luminances[number - part.first] : luminance(part.radiance)) * t.area;
  return out;
}

Vec3f Emitters::centre(uint32_t number) const { return corners(number).middle(); }

LightSample Emitters::sample(uint32_t number, const LitPoint& point, const Vec2f& u) const {
  LightSample s;
  const Corners t = corners(number);
  if (!t.faces(point.position)) return s;
  const Part& part = part_of(number);
  s.radiance = part.radiance;
  if (!t.is_far(point.position)) {
    const SphericalTriangle seen(point.position, t.a, t.b, t.c);
    if (seen.usable()) {
      s.direction = Vec3f(seen.sample(u));
      const float facing = -dot(s.direction, t.normal);
      if (!(facing > 0)) return s;
      s.distance = dot(t.normal, point.position - t.a) / facing;
      s.pdf = static_cast<float>(1 / seen.area);
      if (part.material) {
        const Vec3f on = point.position + s.direction * s.distance - t.a;
        const float twice = 2 * t.area * t.turn;
        const float x = std::clamp(dot(cross(on, t.c - t.a), t.normal) / twice, 0.0f, 1.0f);
        const float y = std::clamp(dot(cross(t.b - t.a, on), t.normal) / twice, 0.0f, 1 - x);
        s.radiance = radiance_at(part, number - part.first, x, y, 0);
      }
      return s;
    }
  }
  const Vec2f at = on_triangle(u);
  if (part.material) s.radiance = radiance_at(part, number - part.first, at.x, at.y, 0);
  const Vec3f to = t.a + (t.b - t.a) * at.x + (t.c - t.a) * at.y - point.position;
  const float squared = dot(to, to);
  s.distance = std::sqrt(squared);
  if (!(s.distance > 0)) return s;
  s.direction = to * (1 / s.distance);
  const float facing = -dot(s.direction, t.normal);
  s.pdf = facing > 0 ? squared / (t.area * facing) : 0;
  return s;
}

float Emitters::pdf(uint32_t number, const LitPoint& point, const Vec3f& direction) const {
  const Corners t = corners(number);
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
