// SPDX-License-Identifier: Apache-2.0
// Small scenes with known answers, and statistics of pictures.
#pragma once

#include <vug/image/image.h>
#include <vug/mesh/shapes.h>
#include <vug/render/kinds.h>
#include <vug/render/render.h>

#include <cmath>
#include <string>

namespace vug::render {

inline Object object(mesh::Mesh mesh, double albedo) {
  Object out;
  out.name = "object";
  out.mesh = std::make_shared<mesh::Mesh>(std::move(mesh));
  out.material = make_material("lambert", {{"albedo", Vec3d(albedo)}});
  return out;
}

/// A square of the floor y = 0, facing up.
inline mesh::Mesh floor_mesh(float half) {
  mesh::Mesh mesh;
  mesh.positions = {{-half, 0, -half}, {-half, 0, half}, {half, 0, half}, {half, 0, -half}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// The mesh, flattened onto the plane y = height.
inline mesh::Mesh at_height(mesh::Mesh mesh, float height) {
  for (Vec3f& p : mesh.positions) p.y = height;
  return mesh;
}

/// Adds normals that point inwards or outwards from the origin.
inline mesh::Mesh with_radial_normals(mesh::Mesh mesh, float sign) {
  for (const Vec3f& p : mesh.positions) mesh.normals.push_back(p * (sign / p.length()));
  return mesh;
}

inline CameraPtr view(const Vec3d& eye, const Vec3d& target, double fov,
                      const Vec3d& up = {0, 1, 0}) {
  return make_camera("perspective",
                     {{"eye", eye}, {"target", target}, {"up", up}, {"fov", radians(fov)}});
}

inline Options options(int width, int height, int spp, int max_bounces) {
  Options o;
  o.width = width, o.height = height, o.spp = spp, o.max_bounces = max_bounces;
  return o;
}

/// Mean of a channel over all pixels and its standard error, from the spread of pixels with equal
/// expected values.
struct Mean {
  double value = 0, error = 0;
};
inline Mean mean_of(const image::Image& picture, const std::string& channel) {
  const auto c = static_cast<size_t>(picture.find_channel(channel));
  const auto n = static_cast<double>(picture.pixel_count());
  double sum = 0, squares = 0;
  for (size_t i = c; i < picture.pixels.size(); i += picture.channels.size()) {
    const auto v = static_cast<double>(picture.pixels[i]);
    sum += v, squares += v * v;
  }
  const double mean = sum / n;
  return {mean, std::sqrt(std::max(0.0, squares / n - mean * mean) / (n - 1))};
}

}  // namespace vug::render
