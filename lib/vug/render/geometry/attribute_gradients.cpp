// SPDX-License-Identifier: Apache-2.0
#include <vug/render/geometry/attribute_gradients.h>

namespace vug::render {
namespace {

double mean(const mesh::Attribute& attribute, uint32_t vertex) {
  const auto arity = static_cast<size_t>(attribute.arity);
  double sum = 0;
  for (size_t k = 0; k < arity; ++k)
    sum += static_cast<double>(attribute.values[vertex * arity + k]);
  return sum / static_cast<double>(arity);
}

/// Gradients at the vertices. On a triangle with corners a, b, c and the area vector
/// n = (b - a) x (c - a) / 2, the gradient of a value f is
/// (f_a n x (c - b) + f_b n x (a - c) + f_c n x (b - a)) / (2 n.n), weighted by the area |n|.
std::vector<Vec3f> gradients(const mesh::Mesh& mesh, const mesh::Attribute& attribute) {
  std::vector<Vec3d> sums(mesh.positions.size(), Vec3d(0));
  std::vector<double> areas(mesh.positions.size(), 0);
  for (const mesh::Triangle& t : mesh.triangles) {
    const Vec3d a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
    const Vec3d n = (b - a).cross(c - a) * 0.5;
    const double area = n.length();
    if (!(area > 0)) continue;
    const double first = mean(attribute, t[0]);
    const Vec3d slope = (n.cross(a - c) * (mean(attribute, t[1]) - first) +
                         n.cross(b - a) * (mean(attribute, t[2]) - first)) /
                        (2 * area);
    for (const uint32_t vertex : t) sums[vertex] += slope, areas[vertex] += area;
  }
  std::vector<Vec3f> out(sums.size(), Vec3f(0));
  for (size_t i = 0; i < out.size(); ++i)
    if (areas[i] > 0) out[i] = Vec3f(sums[i] / areas[i]);
  return out;
}

}  // namespace

AttributeGradients::AttributeGradients(const mesh::Mesh& mesh)
    : mesh_(mesh), gradients_(mesh.attributes.size()) {}

const std::vector<Vec3f>* AttributeGradients::at_vertices(std::string_view name) const {
  const mesh::Attribute* attribute = mesh::find_attribute(mesh_, name);
  if (!attribute || attribute->arity < 1) return nullptr;
  Gradient& slope = gradients_[static_cast<size_t>(attribute - mesh_.attributes.data())];
  std::call_once(slope.once, [&] { slope.at_vertex = gradients(mesh_, *attribute); });
  return &slope.at_vertex;
}

}  // namespace vug::render
