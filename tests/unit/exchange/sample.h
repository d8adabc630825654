// SPDX-License-Identifier: Apache-2.0
// An assembly with known numbers.
#pragma once

#include <vug/exchange/assembly.h>
#include <vug/mesh/normals.h>
#include <vug/mesh/shapes.h>

#include <memory>

namespace vug::exchange {

/// The mesh with weights: shale above half a metre, limestone below.
inline mesh::MeshPtr two_rocks(mesh::Mesh mesh) {
  for (const char* name : {"w_limestone", "w_shale"}) {
    mesh::Attribute weight{name, 1, {}};
    for (const Vec3f& p : mesh.positions)
      weight.values.push_back((p.y > 0.5f) == (weight.name == "w_shale") ? 1.0f : 0.0f);
    mesh.attributes.push_back(std::move(weight));
  }
  return std::make_shared<const mesh::Mesh>(std::move(mesh));
}

/// A cube of 1 m that stands on the ground from (0, 0, 0) to (1, 1, 1), once by itself and three
/// times as instances; two cameras and one light of each shape.
inline Assembly sample() {
  Assembly all;
  all.name = "sample";
  all.provenance = {"seed 7\n# a \"recipe\"\n", 7, 1, "0"};
  mesh::Mesh cube = mesh::box_mesh(Box3d(Vec3d(0.0), Vec3d(1.0)));
  cube.normals = mesh::vertex_normals(cube);
  cube.attributes = {{"Cd", 3, {}}, {"wetness", 1, {}}, {"flow", 3, {}}};
  for (size_t v = 0; v < cube.positions.size(); ++v) {
    const auto part = static_cast<float>(v) / 8;
    cube.attributes[0].values.insert(cube.attributes[0].values.end(), {part, 0.5F, 1});
    cube.attributes[1].values.push_back(part);
    cube.attributes[2].values.insert(cube.attributes[2].values.end(), {0, 1, 0});
  }
  Prototype part{"cube", std::make_shared<const mesh::Mesh>(std::move(cube)), "rock", {}, {}};
  part.look.specular = 0.25;
  part.look.wetness = 0.5;
  all.prototypes = {part};
  all.groups = {{"cube", 0, {Transform()}}, {"strewn", 0, {}}};
  for (int i = 1; i <= 3; ++i)
    all.groups[1].places.push_back(Transform::translation({2.0 * i, 0, -1}) *
                                   Transform::rotation({0, 1, 0}, 0.5 * kPi) *
                                   Transform::scaling(Vec3d(0.5)));
  Camera view;
  view.name = "main";
  view.place = Transform::translation({0, 1.5, 4});
  view.fov = 0.5 * kPi;
  view.aspect = 2;
  view.size = {640, 320};
  view.aperture = 0.01;
  view.focus = 3;
  Camera plan = view;
  plan.name = "plan";
  plan.orthographic = true;
  plan.place = plan.place * Transform::rotation({1, 0, 0}, -0.5 * kPi);
  all.cameras = {view, plan};
  using Shape = Light::Shape;
  for (const Shape shape :
       {Shape::sphere, Shape::rectangle, Shape::disk, Shape::spot, Shape::sun, Shape::dome}) {
    Light light;
    light.name = "lamp" + std::to_string(static_cast<int>(shape));
    light.shape = shape;
    light.place = Transform::translation({0, 3, 0}) * Transform::rotation({1, 0, 0}, -0.5 * kPi);
    light.radiance = {4, 2, 1};
    light.radius = 0.25;
    light.width = 0.5;
    light.height = 0.25;
    light.angle = shape == Shape::sun ? 0.01 : 1;
    light.edge = 0.2;
    all.lights.push_back(light);
  }
  return all;
}

}  // namespace vug::exchange
