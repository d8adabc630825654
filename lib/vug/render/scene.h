// SPDX-License-Identifier: Apache-2.0
// The scene to be rendered, as plain data. Objects are shared and immutable.
#pragma once

#include <vug/mesh/mesh.h>
#include <vug/paint/paint.h>
#include <vug/render/camera.h>
#include <vug/render/geometry/instance_transform.h>
#include <vug/render/light.h>
#include <vug/render/material.h>
#include <vug/render/media/medium.h>
#include <vug/volume/surface_bricks.h>

#include <memory>
#include <string>
#include <vector>

namespace vug::render {

/// A mesh or a level set, with its material. Vertex colours (attribute "Cd", arity 3) multiply the
/// material's colour. Vertex normals, if present, give smooth shading unless `flat` is set.
struct Object {
  std::string name;
  mesh::MeshPtr mesh;
  MaterialPtr material;  ///< Null: a grey Lambertian surface of albedo 0.5.
  bool flat = false;
  /// Radiance (W/sr/m^2) emitted by the outer side of its triangles.
  Rgb emission{0, 0, 0};
  std::string light_group;                ///< Light group of its emission; see LightLinking.
  std::string material_name = "default";  ///< For Cryptomatte.
  /// The level set from which the mesh was made, for masks that depend on the rock around a point.
  std::shared_ptr<const field::SampledGrid> solid = nullptr;
  /// Null: the mesh is in world space. Otherwise this is an instance: instances of the same mesh
  /// share its BVH and need almost no memory of their own.
  InstanceTransformPtr instance = nullptr;
  /// For instances: the material is evaluated in world space instead of the mesh's own space.
  bool world_space_material = false;
  /// Replaces the mesh: the surface of a level set, ray traced directly (see first_crossing). It
  /// has no attributes and cannot emit light.
  volume::SurfaceBricksPtr surface = nullptr;
  paint::Paint color = nullptr;  ///< With `surface`: replaces vertex colours; may be null.
  /// Mesh attributes that are 1 at vertices of an element kind and 0 elsewhere.
  std::vector<std::string> elements = {};
};

/// The box around an object in world space, of an instance where it is at time 0; empty if the
/// object is.
Box3d object_bounds(const Object& object);

struct Scene {
  CameraPtr camera;
  std::vector<Object> objects;
  std::vector<LightPtr>
      lights;        ///< Finite and infinite lights; the radiance of environments adds up.
  MediumPtr medium;  ///< Null: vacuum.
  /// Names of objects that the picture omits, to which lights may be linked without effect.
  std::vector<std::string> omitted = {};
};

}  // namespace vug::render
