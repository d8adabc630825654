// SPDX-License-Identifier: Apache-2.0
#include <vug/delivery/point_file.h>
#include <vug/mesh/byte_writer.h>
#include <vug/mesh/file.h>

#include <fmt/format.h>

#include <array>

namespace vug::delivery {
namespace {

using volume::PointAttribute;

std::array<std::string, 3> names_of(const std::string& vectors) {
  if (vectors == "N") return {"nx", "ny", "nz"};
  if (vectors == "Cd") return {"red", "green", "blue"};
  return {vectors + "_0", vectors + "_1", vectors + "_2"};
}

void declare(mesh::ByteWriter& out, const PointAttribute& attribute) {
  const auto property = [&](const char* type, const std::string& name) {
    out.text(fmt::format("property {} {}\n", type, name));
  };
  if (std::holds_alternative<std::vector<Vec3f>>(attribute.values))
    for (const std::string& name : names_of(attribute.name)) property("float", name);
  else
    property(std::holds_alternative<std::vector<int32_t>>(attribute.values) ? "int" : "float",
             attribute.name);
}

}  // namespace

void write_points(const volume::Points& points, const std::filesystem::path& file,
                  const mesh::Comments& notes) {
  const auto triple = [](mesh::ByteWriter& out, const Vec3f& p) {
    out.binary(p.x).binary(p.y).binary(p.z);
  };
  mesh::write_file(file, [&](const mesh::ByteSink& sink) {
    mesh::ByteWriter out(sink);
    out.text("ply\nformat binary_little_endian 1.0\n");
    out.text(mesh::comment_lines(notes, "comment "));
    out.text(fmt::format("element vertex {}\n", points.position.size()));
    for (const char* axis : {"x", "y", "z"}) out.text(fmt::format("property float {}\n", axis));
    for (const PointAttribute& each : points.attributes) declare(out, each);
    // Readers of meshes expect the element face, even if it is empty.
    out.text("element face 0\nproperty list uchar int vertex_indices\nend_header\n");
    for (size_t i = 0; i < points.position.size(); ++i) {
      triple(out, points.position[i]);
      for (const PointAttribute& each : points.attributes)
        if (const auto* vectors = std::get_if<std::vector<Vec3f>>(&each.values))
          triple(out, (*vectors)[i]);
        else if (const auto* whole = std::get_if<std::vector<int32_t>>(&each.values))
          out.binary((*whole)[i]);
        else
          out.binary(std::get<std::vector<float>>(each.values)[i]);
    }
    out.finish();
  });
}

}  // namespace vug::delivery
