// SPDX-License-Identifier: Apache-2.0
#include <vug/mesh/mesh.h>
#include <vug/render/geometry/attribute_gradients.h>
#include <vug/render/geometry/instance_transform.h>
#include <vug/render/materials/material_input.h>

#include <algorithm>

namespace vug::render {

SurfacePoint::SurfacePoint(const Surface& surface) : surface_(surface) {
  point_.position = Vec3d(surface.position);
  // Masks use the normal out of the solid, regardless of the viewer's side.
  point_.normal = Vec3d(surface.shading_normal) * (surface.inside ? -1 : 1);
  point_.solid = surface.solid;
  point_.attributes = this;
  point_.footprint = static_cast<double>(surface.footprint);
  if (!surface.instance) return;
  own_ = surface.instance->inverse(surface.time);
  if (surface.world_space_material) {
    point_.to_solid = &*own_;
    return;
  }
  in_scene_ = point_;
  in_scene_.to_solid = &*own_;
  point_.in_scene = &in_scene_;
  point_.position = own_->point(point_.position);
  point_.normal = own_->normal(point_.normal).normalized();
  point_.footprint /= static_cast<double>(surface.instance->mean_scale());
}

void SurfacePoint::move_to(const Vec3f& point) {
  const Vec3d from(surface_.position), to(point);
  moved_ = own_ ? own_->point(to) - own_->point(from) : to - from;
  point_.position = own_ && !surface_.world_space_material ? own_->point(to) : to;
  in_scene_.position = to;
}

std::optional<Vec3d> SurfacePoint::read(std::string_view name) const {
  if (!surface_.mesh && name == mesh::kColour) return Vec3d(surface_.color);
  if (!surface_.mesh) return std::nullopt;
  const mesh::Attribute* attribute = mesh::find_attribute(*surface_.mesh, name);
  if (!attribute || attribute->arity < 1) return std::nullopt;
  const mesh::Triangle& corners = surface_.mesh->triangles[surface_.triangle];
  const float shares[] = {1 - surface_.u - surface_.v, surface_.u, surface_.v};
  Vec3d value(0.0);
  for (size_t corner = 0; corner < 3; ++corner)
    for (int part = 0; part < 3; ++part) {
      const auto arity = static_cast<size_t>(attribute->arity);
      const size_t own = attribute->arity < 3 ? 0 : static_cast<size_t>(part);
      value[part] +=
          static_cast<double>(shares[corner] * attribute->values[corners[corner] * arity + own]);
    }
  if (const auto* gradients =
          moved_ && surface_.gradients ? surface_.gradients->at_vertices(name) : nullptr) {
    Vec3f slope(0);
    for (size_t corner = 0; corner < 3; ++corner)
      slope += (*gradients)[corners[corner]] * shares[corner];
    value += Vec3d(moved_->dot(Vec3d(slope)));
  }
  return value;
}

float NumberInput::at(const paint::EvalPoint& point, float low, float high) const {
  const auto number = static_cast<float>(varying ? (*varying)(point) : constant);
  return std::min(high, std::max(low, number));  // NaN becomes low
}

Rgb ColorInput::at(const paint::EvalPoint& point, const Rgb& times) const {
  const Vec3d color = varying ? (*varying)(point) : constant;
  const auto one = [](double x) { return static_cast<float>(std::min(1.0, std::max(0.0, x))); };
  return from_rec709(Rgb(one(color.x), one(color.y), one(color.z)) * times);
}

}  // namespace vug::render

namespace vug {

std::optional<render::NumberInput> ValueTraits<render::NumberInput>::read(const Value& v) {
  if (const Number* number = v.get<Number>()) return render::NumberInput(number->value);
  if (const auto* mask = v.object<paint::Mask>()) return render::NumberInput(*mask);
  return std::nullopt;
}
Value ValueTraits<render::NumberInput>::write(const render::NumberInput& input) {
  return input.varying ? ValueTraits<paint::Mask>::write(input.varying) : Value(input.constant);
}

std::optional<render::ColorInput> ValueTraits<render::ColorInput>::read(const Value& v) {
  if (const auto* vector = v.get<Value::Vector>()) return render::ColorInput(vector->value);
  if (const auto* paint = v.object<paint::Paint>()) return render::ColorInput(*paint);
  return std::nullopt;
}
Value ValueTraits<render::ColorInput>::write(const render::ColorInput& input) {
  return input.varying ? ValueTraits<paint::Paint>::write(input.varying) : Value(input.constant);
}

}  // namespace vug
