// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/field/kind.h>
#include <vug/flora/polygon_mesh.h>
#include <vug/flora/shape.h>
#include <vug/flora/sweep_field.h>
#include <vug/flora/sweep_mesh.h>
#include <vug/shot/lsystem_plan.h>
#include <vug/shot/mesh_source.h>

namespace vug::shot {

mesh::Mesh mesh_from_source(const MeshSource& drawn, double tolerance) {
  if (drawn.shape) return *drawn.shape;
  if (drawn.polygons) return flora::polygon_mesh(*drawn.polygons->drawing());
  const std::vector<flora::Tube> tubes = flora::tubes_of(drawn.stems);
  if (tubes.empty() && !drawn.stems.bounds().isEmpty())
    throw Error(ErrorCode::bad_input, "this solid does not consist of stems only", {},
                "for other solids: volume NAME = level_set(...), mesh NAME on VOLUME");
  flora::MeshOptions options;
  options.tolerance = tolerance;
  return flora::swept_mesh(tubes, options);
}

}  // namespace vug::shot

namespace vug {

std::optional<shot::MeshSource> ValueTraits<shot::MeshSource>::read(const Value& value) {
  if (const auto plant = ValueTraits<shot::LSystemPtr>::read(value))
    return shot::MeshSource{field::Field(), *plant, nullptr};
  if (const auto solid = ValueTraits<field::Field>::read(value))
    return shot::MeshSource{*solid, nullptr, nullptr};
  if (const auto* shape = value.object<flora::Shape>())
    return shot::MeshSource{field::Field(), nullptr, shape->mesh};
  return std::nullopt;
}

}  // namespace vug
