// SPDX-License-Identifier: Apache-2.0
// STL: independent triangles without shared vertices.
#include <vug/mesh/byte_writer.h>
#include <vug/mesh/format_kind.h>
#include <vug/mesh/text_scanner.h>
#include <vug/mesh/weld.h>

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace vug::mesh {
namespace {

constexpr size_t kHeader = 80;
constexpr size_t kRecord = 50;  ///< Normal, three corners, two unused bytes.

void add_corner(Mesh& mesh, const Vec3f& p) {
  mesh.positions.push_back(p);
  const auto n = static_cast<uint32_t>(mesh.positions.size());
  if (n % 3 == 0) mesh.triangles.push_back({n - 3, n - 2, n - 1});
}

Mesh read_binary(std::string_view bytes, const std::string& file, uint32_t count) {
  Mesh mesh;
  mesh.positions.reserve(3 * size_t{count});
  mesh.triangles.reserve(count);
  for (size_t i = 0; i < count; ++i)
    for (size_t k = 0; k < 3; ++k) {
      const size_t at = kHeader + 4 + kRecord * i + sizeof(Vec3f) * (k + 1);
      Vec3f p;
      std::memcpy(static_cast<void*>(&p), bytes.data() + at, sizeof p);
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        throw Error(ErrorCode::bad_input,
                    fmt::format("a corner of triangle {} is not finite (byte {})", i, at),
                    {file, 0, 0});
      add_corner(mesh, p);
    }
  return mesh;
}

Mesh read_text_form(std::string_view bytes, const std::string& file) {
  constexpr double kLimit = std::numeric_limits<float>::max();
  TextScanner scan(bytes, file);
  Mesh mesh;
  const auto expect = [&](std::string_view wanted) {
    const std::string_view word = scan.word();
    if (word != wanted)
      scan.fail(word.empty()
                    ? fmt::format("the file ends where '{}' is expected", wanted)
                    : fmt::format("found '{}', expected '{}'", mesh::printable(word), wanted),
                "the file may be cut off");
  };
  const auto triple = [&] {
    Vec3f v;
    for (int axis = 0; axis < 3; ++axis) {
      const double number = scan.number(scan.word());
      if (std::fabs(number) > kLimit) scan.fail("a number is too large for single precision");
      v[axis] = static_cast<float>(number);
    }
    return v;
  };
  for (std::string_view word = scan.word(); !word.empty(); word = scan.word()) {
    if (word != "solid")
      scan.fail(fmt::format("found '{}', expected 'solid'", mesh::printable(word)));
    scan.rest_of_line();  // The solid's name.
    for (word = scan.word(); word == "facet"; word = scan.word()) {
      expect("normal");
      triple();
      expect("outer");
      expect("loop");
      for (int k = 0; k < 3; ++k) {
        expect("vertex");
        add_corner(mesh, triple());
      }
      expect("endloop");
      expect("endfacet");
    }
    if (word != "endsolid")
      scan.fail(word.empty() ? "the file ends inside a solid"
                             : fmt::format("found '{}', expected 'facet' or 'endsolid'",
                                           mesh::printable(word)),
                "the file may be cut off");
    scan.rest_of_line();
  }
  return mesh;
}

Mesh read_stl(std::string_view bytes, const std::string& file) {
  uint32_t count = 0;
  if (bytes.size() >= kHeader + 4) std::memcpy(&count, bytes.data() + kHeader, sizeof count);
  // Many binary files also begin with "solid", so the length decides.
  const bool length_fits =
      bytes.size() >= kHeader + 4 && bytes.size() == kHeader + 4 + kRecord * uint64_t{count};
  if (length_fits) return welded(read_binary(bytes, file, count));
  if (bytes.substr(0, 5) == "solid") return welded(read_text_form(bytes, file));
  throw Error(
      ErrorCode::bad_input,
      fmt::format("{} bytes are neither an STL text nor the {} triangles that the header announces",
                  bytes.size(), count),
      {file, 0, 0}, "the file may be truncated, or not an STL file");
}

void write_stl(const Mesh& mesh, const Comments& notes, const ByteSink& sink) {
  if (mesh.triangles.size() > UINT32_MAX)
    throw Error(ErrorCode::bad_input, "STL holds at most 4294967295 triangles");
  ByteWriter out(sink);
  std::string header = "Vug mesh, " + notes.space;
  header.resize(kHeader, ' ');
  out.text(header).binary(static_cast<uint32_t>(mesh.triangles.size()));
  const auto triple = [&](const Vec3f& p) { out.binary(p.x).binary(p.y).binary(p.z); };
  for (size_t face = 0; face < mesh.triangles.size(); ++face) {
    triple(Vec3f(double_area_vector(mesh, face).normalized()));
    for (const uint32_t corner : mesh.triangles[face]) triple(mesh.positions[corner]);
    out.binary(uint16_t{0});
  }
  out.finish();
}

}  // namespace
}  // namespace vug::mesh

VUG_MESH_FORMAT(stl) {
  return mesh_format("stl",
                     "Triangle soup: positions only. Read as text or binary, with vertices at "
                     "equal positions merged and degenerate triangles dropped; written as binary",
                     "roscoe1988", read_stl, write_stl);
}
