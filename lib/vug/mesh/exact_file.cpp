// SPDX-License-Identifier: Apache-2.0
#include <vug/base/binary_stream.h>
#include <vug/mesh/exact_file.h>

namespace vug::mesh {

void write_exact(std::ostream& out, const Attribute& attribute) {
  write_list(out, attribute.name);
  write_list(out, std::vector<int>{attribute.arity});
  write_list(out, attribute.values);
}

Attribute read_exact_attribute(std::istream& in) {
  Attribute out;
  out.name = read_list<std::string>(in);
  out.arity = read_list<std::vector<int>>(in).at(0);
  out.values = read_list<std::vector<float>>(in);
  return out;
}

void write_exact(std::ostream& out, const Mesh& mesh) {
  write_list(out, mesh.positions);
  write_list(out, mesh.triangles);
  write_list(out, mesh.normals);
  write_list(out, std::vector<uint64_t>{mesh.attributes.size()});
  for (const Attribute& each : mesh.attributes) write_exact(out, each);
}

Mesh read_exact_mesh(std::istream& in) {
  Mesh out;
  out.positions = read_list<std::vector<Vec3f>>(in);
  out.triangles = read_list<std::vector<Triangle>>(in);
  out.normals = read_list<std::vector<Vec3f>>(in);
  const uint64_t attributes = read_list<std::vector<uint64_t>>(in).at(0);
  for (uint64_t i = 0; i < attributes; ++i) out.attributes.push_back(read_exact_attribute(in));
  return out;
}

}  // namespace vug::mesh
