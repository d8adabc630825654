// SPDX-License-Identifier: Apache-2.0
// Point clouds from PLY files.
#include <vug/mesh/ply_body.h>
#include <vug/mesh/ply_header.h>
#include <vug/scan/read.h>

#include <array>
#include <cmath>

namespace vug::scan {
namespace {

using mesh::PlyElement;
using mesh::PlyProperty;
using mesh::PlyType;

/// Vertex properties that clouds store.
enum VertexField : size_t {
  kX,
  kY,
  kZ,
  kRed,
  kGreen,
  kBlue,
  kIntensity,
  kNx,
  kNy,
  kNz,
  kSlots,
  kUnusedField
};

VertexField field_of(const PlyProperty& property) {
  constexpr std::pair<std::string_view, VertexField> kNames[] = {{"x", kX},
                                                                 {"y", kY},
                                                                 {"z", kZ},
                                                                 {"red", kRed},
                                                                 {"green", kGreen},
                                                                 {"blue", kBlue},
                                                                 {"diffuse_red", kRed},
                                                                 {"diffuse_green", kGreen},
                                                                 {"diffuse_blue", kBlue},
                                                                 {"intensity", kIntensity},
                                                                 {"scalar_intensity", kIntensity},
                                                                 {"scalar_Intensity", kIntensity},
                                                                 {"reflectance", kIntensity},
                                                                 {"nx", kNx},
                                                                 {"ny", kNy},
                                                                 {"nz", kNz}};
  if (!property.is_list)
    for (const auto& [name, slot] : kNames)
      if (name == property.name) return slot;
  return kUnusedField;
}

/// Divisor that maps a number of the type to 0..1.
double full_scale(PlyType type) {
  return type == PlyType::uint8 ? 255 : type == PlyType::uint16 ? 65535 : 1;
}

struct VertexLayout {
  std::vector<VertexField> slots;  ///< One per property.
  std::array<bool, kSlots> given{};

  bool all(std::initializer_list<VertexField> slots_of_one) const {
    for (const VertexField slot : slots_of_one)
      if (!given[slot]) return false;
    return true;
  }
};

VertexLayout vertex_layout(const PlyElement& element, const std::string& file) {
  VertexLayout layout;
  for (const PlyProperty& property : element.properties) {
    layout.slots.push_back(field_of(property));
    if (layout.slots.back() != kUnusedField) layout.given[layout.slots.back()] = true;
  }
  if (!layout.all({kX, kY, kZ}))
    throw Error(ErrorCode::bad_input, "the vertices have no x, y or z", {file, element.line, 1});
  return layout;
}

template <class Body>
void skip_property(Body& body, const PlyProperty& property) {
  double count = 1;
  if (property.is_list) {
    count = body.number(property.count_type);
    if (!(count >= 0 && count <= UINT32_MAX && count == std::floor(count)))
      body.fail("invalid length of a list");
    body.require(static_cast<uint64_t>(count), property.type);
  }
  for (; count > 0; --count) body.number(property.type);
}

template <class Body>
void read_vertices(Body& body, const PlyElement& element, const VertexLayout& layout,
                   PointCloud& cloud) {
  const bool coloured = layout.all({kRed, kGreen, kBlue});
  const bool normals = layout.all({kNx, kNy, kNz});
  std::array<double, kSlots> value{};
  const auto triple = [&](VertexField first) {
    return Vec3f(static_cast<float>(value[first]), static_cast<float>(value[first + 1]),
                 static_cast<float>(value[first + 2]));
  };
  for (uint64_t v = 0; v < element.count; ++v) {
    for (size_t i = 0; i < layout.slots.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      const VertexField slot = layout.slots[i];
      if (slot == kUnusedField)
        skip_property(body, property);
      else
        value[slot] = body.number(property.type) /
                      (slot >= kRed && slot <= kBlue ? full_scale(property.type) : 1);
    }
    if (!(std::isfinite(value[kX]) && std::isfinite(value[kY]) && std::isfinite(value[kZ]))) {
      ++cloud.dropped;
      continue;
    }
    cloud.positions.emplace_back(value[kX], value[kY], value[kZ]);
    if (coloured) cloud.colours.push_back(triple(kRed));
    if (normals) cloud.normals.push_back(triple(kNx));
    if (layout.given[kIntensity])
      cloud.intensities.push_back(static_cast<float>(value[kIntensity]));
  }
}

template <class Body>
PointCloud read_elements(Body body, const mesh::PlyHeader& header, const std::string& file,
                         const ReadOptions& options) {
  PointCloud cloud;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") {
      const VertexLayout layout = vertex_layout(element, file);
      require_memory(static_cast<double>(element.count) * (sizeof(Vec3d) + 2 * sizeof(Vec3f) + 4),
                     options.memory, "the cloud of " + file, "reduce the number of points");
      read_vertices(body, element, layout, cloud);
      return cloud;  // Later elements are not needed.
    }
    if (!element.properties.empty())
      for (uint64_t i = 0; i < element.count; ++i)
        for (const PlyProperty& property : element.properties) skip_property(body, property);
  }
  throw Error(ErrorCode::bad_input, "the file has no vertices", {file, 1, 1});
}

}  // namespace

PointCloud parse_ply(std::string_view bytes, const std::string& file, const ReadOptions& options) {
  const mesh::PlyHeader header = mesh::read_ply_header(bytes, file);
  if (header.encoding == mesh::PlyHeader::Encoding::ascii)
    return read_elements(mesh::PlyTextBody(bytes, file, header, mesh::NotFinite::kept), header,
                         file, options);
  return read_elements(mesh::PlyBinaryBody(bytes, file, header, mesh::NotFinite::kept), header,
                       file, options);
}

}  // namespace vug::scan
