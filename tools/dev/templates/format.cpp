//@ lib/vug/mesh/formats
// SPDX-License-Identifier: Apache-2.0
// STUB: the format, and the data of a mesh that it cannot store.
#include <vug/mesh/byte_writer.h>
#include <vug/mesh/format_kind.h>
#include <vug/mesh/text_scanner.h>

#include <fmt/format.h>

namespace vug::mesh {
namespace {

/// Reads "v x y z" for each vertex and "t a b c" for each triangle, with indices from 0.
Mesh read_new_kind(std::string_view bytes, const std::string& file) {
  Mesh mesh;
  TextScanner scan(bytes, file);
  for (std::string_view word = scan.word(); !word.empty(); word = scan.word()) {
    if (word == "v") {
      Vec3f p;
      for (int axis = 0; axis < 3; ++axis) p[axis] = static_cast<float>(scan.number(scan.word()));
      mesh.positions.push_back(p);
    } else if (word == "t") {
      Triangle triangle;
      for (uint32_t& corner : triangle) {
        const int64_t index = scan.integer(scan.word());
        if (index < 0 || static_cast<size_t>(index) >= mesh.positions.size())
          scan.fail(fmt::format("invalid vertex index {}", index));
        corner = static_cast<uint32_t>(index);
      }
      mesh.triangles.push_back(triangle);
    } else {
      scan.fail(fmt::format("'{}' is neither v nor t", printable(word)));
    }
  }
  return mesh;
}

void write_new_kind(const Mesh& mesh, const Comments&, const ByteSink& sink) {
  ByteWriter out(sink);
  for (const Vec3f& p : mesh.positions)
    out.text("v ").number(p.x).text(" ").number(p.y).text(" ").number(p.z).text("\n");
  for (const Triangle& t : mesh.triangles)
    out.text("t ").number(t[0]).text(" ").number(t[1]).text(" ").number(t[2]).text("\n");
  out.finish();
}

}  // namespace
}  // namespace vug::mesh

VUG_MESH_FORMAT(new_kind) {
  return mesh_format("new_kind", "STUB: the data of a mesh that the format stores and omits", "",
                     read_new_kind, write_new_kind);
}
