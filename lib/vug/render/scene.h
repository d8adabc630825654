// What is rendered, as plain data. Objects are shared and never changed.
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

/// A mesh, or a level set, and its material. Vertex colours (attribute "Cd", arity 3) multiply the
/// material's colour; vertex normals, where the mesh has them, shade it smoothly unless `flat` is
/// set.
struct Object {
  std::string name;
  mesh::MeshPtr mesh;
  MaterialPtr material;  ///< Null: a grey Lambert surface of albedo 0.5.
  bool flat = false;
  /// Radiance (W/sr/m^2) that its triangles send out from their front, the outside.
  Rgb emission{0, 0, 0};
  std::string light_group;                ///< Of its emission; see LightLinking.
  std::string material_name = "default";  ///< For mattes.
  /// The level set that the mesh was made of, for masks that ask about the rock around a place.
  std::shared_ptr<const field::SampledGrid> solid = nullptr;
  /// Null: the mesh stands in the scene as it is. Else this is an instance: all that share a mesh
  /// share its tree, and cost next to no memory of their own.
  InstanceTransformPtr instance = nullptr;
  /// Of an instance: its material sees the place it stands at, instead of the mesh's own space.
  bool world_space_material = false;
  /// In place of a mesh: the surface of a level set, traced as it is (see first_crossing). It has
  /// no attributes and cannot shine.
  volume::SurfaceBricksPtr surface = nullptr;
  paint::Paint color = nullptr;  ///< With `surface`: what the vertex colours would be; or null.
  /// Attributes of the mesh that are 1 where a vertex is of a kind of element and 0 elsewhere.
  std::vector<std::string> elements = {};
};

struct Scene {
  CameraPtr camera;
  std::vector<Object> objects;
  std::vector<LightPtr> lights;  ///< Lamps and skies; skies add up.
  MediumPtr medium;              ///< Null: clear air.
};

}  // namespace vug::render
