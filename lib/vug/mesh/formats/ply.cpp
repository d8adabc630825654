// SPDX-License-Identifier: Apache-2.0
// Stanford PLY: reads properties in any order, writes little-endian binary.
#include <vug/mesh/byte_writer.h>
#include <vug/mesh/format_kind.h>
#include <vug/mesh/ply_body.h>
#include <vug/mesh/polygon.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace vug::mesh {
namespace {

constexpr std::string_view kCoordinates[] = {"x", "y", "z"};
constexpr std::string_view kNormals[] = {"nx", "ny", "nz"};
constexpr std::string_view kColours[] = {"red", "green", "blue"};

/// Destination of the numbers of one vertex property: `list[stride * vertex + offset]`.
struct Column {
  PlyType type = PlyType::float32;
  bool is_list = false;  ///< Read and discarded.
  PlyType count_type = PlyType::uint8;
  float* list = nullptr;
  size_t stride = 0;
  double scale = 1;
};

/// Full scale of integers that represent ratios (colours); 1 for other types.
double full_scale(PlyType type) {
  if (!is_whole(type)) return 1;
  return type == PlyType::uint8 ? 255 : type == PlyType::uint16 ? 65535 : 1;
}

const PlyProperty* find_property(const PlyElement& element, std::string_view name) {
  for (const PlyProperty& p : element.properties)
    if (p.name == name && !p.is_list) return &p;
  return nullptr;
}

bool has_all(const PlyElement& element, const std::string_view (&names)[3]) {
  return std::all_of(std::begin(names), std::end(names),
                     [&](std::string_view name) { return find_property(element, name); });
}

std::optional<size_t> position_in(const std::string_view (&names)[3], std::string_view name) {
  const auto found = std::find(std::begin(names), std::end(names), name);
  if (found == std::end(names)) return std::nullopt;
  return static_cast<size_t>(found - std::begin(names));
}

/// "flow_2" is component 2 of "flow" if 0 and 1 precede it.
std::optional<std::string> base_of_component(const std::string& name, int component) {
  const std::string ending = fmt::format("_{}", component);
  if (name.size() <= ending.size() || !name.ends_with(ending)) return std::nullopt;
  return name.substr(0, name.size() - ending.size());
}

/// Length of the run of properties, starting at `from`, that are components of one attribute.
size_t run_of_components(const std::vector<PlyProperty>& properties, size_t at) {
  const auto base = base_of_component(properties[at].name, 0);
  size_t length = 1;
  while (base && at + length < properties.size() && !properties[at + length].is_list &&
         base_of_component(properties[at + length].name, static_cast<int>(length)) == base)
    ++length;
  return length;
}

std::vector<Column> plan_vertices(const PlyElement& element, Mesh& mesh) {
  const size_t count = element.count;
  const bool normals = has_all(element, kNormals);
  const bool colours = has_all(element, kColours);
  mesh.positions.resize(count, Vec3f(0));
  if (normals) mesh.normals.resize(count, Vec3f(0));
  if (colours) mesh.attributes.push_back({std::string(kColour), 3, std::vector<float>(3 * count)});
  std::vector<Column> columns;
  const std::vector<PlyProperty>& all = element.properties;
  for (size_t i = 0; i < all.size(); ++i) {
    Column column{all[i].type, all[i].is_list, all[i].count_type};
    const auto go = [&](float* list, size_t offset, size_t stride, double scale) {
      column.list = count > 0 ? list + offset : nullptr;
      column.stride = stride;
      column.scale = scale;
      columns.push_back(column);
    };
    const auto x = position_in(kCoordinates, all[i].name);
    const auto n = position_in(kNormals, all[i].name);
    const auto c = position_in(kColours, all[i].name);
    if (column.is_list) {
      columns.push_back(column);
    } else if (x) {
      go(reinterpret_cast<float*>(mesh.positions.data()), *x, 3, 1);
    } else if (n && normals) {
      go(reinterpret_cast<float*>(mesh.normals.data()), *n, 3, 1);
    } else if (c && colours) {
      // Moving the list of attributes does not move their values.
      go(mesh.attributes[0].values.data(), *c, 3, 1 / full_scale(column.type));
    } else {
      const size_t arity = run_of_components(all, i);
      const std::string name = arity > 1 ? *base_of_component(all[i].name, 0) : all[i].name;
      mesh.attributes.push_back({name, static_cast<int>(arity), std::vector<float>(arity * count)});
      for (size_t k = 0; k < arity; ++k) {
        column.type = all[i + k].type;
        go(mesh.attributes.back().values.data(), k, arity,
           all[i].name == "alpha" ? 1 / full_scale(column.type) : 1);
      }
      i += arity - 1;
    }
  }
  return columns;
}

template <class Body>
uint64_t list_length(Body& body, PlyType count_type, PlyType type) {
  const double length = body.number(count_type);
  if (length < 0 || length != std::floor(length) || length > UINT32_MAX)
    body.fail("the length of a list must not be negative or fractional");
  body.require(static_cast<uint64_t>(length), type);
  return static_cast<uint64_t>(length);
}

template <class Body>
void read_vertices(Body& body, const PlyElement& element, Mesh& mesh) {
  constexpr double kLimit = std::numeric_limits<float>::max();
  const std::vector<Column> columns = plan_vertices(element, mesh);
  for (uint64_t v = 0; v < element.count; ++v)
    for (const Column& column : columns) {
      uint64_t numbers = column.is_list ? list_length(body, column.count_type, column.type) : 1;
      for (; numbers > 0; --numbers) {
        const double value = body.number(column.type) * column.scale;
        if (std::fabs(value) > kLimit) body.fail("a number is too large for single precision");
        if (column.list) column.list[column.stride * v] = static_cast<float>(value);
      }
    }
}

template <class Body>
void read_faces(Body& body, const PlyElement& element, uint64_t vertices, Mesh& mesh) {
  std::vector<uint32_t> polygon;
  for (uint64_t f = 0; f < element.count; ++f)
    for (const PlyProperty& p : element.properties) {
      uint64_t numbers = p.is_list ? list_length(body, p.count_type, p.type) : 1;
      const bool corners = p.is_list && (p.name == "vertex_indices" || p.name == "vertex_index");
      polygon.clear();
      for (; numbers > 0; --numbers) {
        const double value = body.number(p.type);
        if (!corners) continue;
        if (value < 0 || value != std::floor(value) || value >= static_cast<double>(vertices))
          body.fail(fmt::format("face {} uses vertex {} of {}", f, value, vertices));
        polygon.push_back(static_cast<uint32_t>(value));
      }
      if (corners && polygon.size() < 3)
        body.fail(fmt::format("face {} has {} corners", f, polygon.size()));
      if (corners) add_polygon(mesh, polygon);
    }
}

template <class Body>
Mesh read_elements(Body body, const PlyHeader& header, const std::string& file) {
  Mesh mesh;
  const PlyElement* vertices = nullptr;
  for (const PlyElement& element : header.elements) {
    const SourceLocation where{file, element.line, 1};
    if (element.name == "vertex") {
      if (!has_all(element, kCoordinates))
        throw Error(ErrorCode::bad_input, "vertices lack x, y or z", where);
      if (element.count > UINT32_MAX)
        throw Error(ErrorCode::bad_input, "more than 4294967295 vertices", where);
      vertices = &element;
      read_vertices(body, element, mesh);
    } else if (element.name == "face") {
      if (!vertices) throw Error(ErrorCode::bad_input, "the faces precede the vertices", where);
      read_faces(body, element, vertices->count, mesh);
    } else if (!element.properties.empty()) {
      for (uint64_t i = 0; i < element.count; ++i)
        for (const PlyProperty& p : element.properties)
          for (uint64_t n = p.is_list ? list_length(body, p.count_type, p.type) : 1; n > 0; --n)
            body.number(p.type);
    }
  }
  if (!vertices) throw Error(ErrorCode::bad_input, "the file contains no vertices", {file, 1, 1});
  return mesh;
}

Mesh read_ply(std::string_view bytes, const std::string& file) {
  const PlyHeader header = read_ply_header(bytes, file);
  if (header.encoding == PlyHeader::Encoding::ascii)
    return read_elements(PlyTextBody(bytes, file, header), header, file);
  return read_elements(PlyBinaryBody(bytes, file, header), header, file);
}

/// Names of the properties for the attribute; throws Error(bad_input) for names that PLY cannot
/// represent.
std::vector<std::string> property_names(const Attribute& attribute) {
  if (attribute.name == kColour && attribute.arity == 3)
    return {std::begin(kColours), std::end(kColours)};
  const bool plain = std::all_of(attribute.name.begin(), attribute.name.end(),
                                 [](char c) { return c > ' ' && c <= '~'; });
  if (attribute.name.empty() || !plain)
    throw Error(ErrorCode::bad_input, fmt::format("'{}' cannot be the name of a PLY property",
                                                  mesh::printable(attribute.name)));
  if (attribute.arity == 1) return {attribute.name};
  std::vector<std::string> names;
  for (int k = 0; k < attribute.arity; ++k)
    names.push_back(fmt::format("{}_{}", attribute.name, k));
  return names;
}

void write_ply(const Mesh& mesh, const Comments& notes, const ByteSink& sink) {
  std::vector<std::string> names(std::begin(kCoordinates), std::end(kCoordinates));
  if (!mesh.normals.empty()) names.insert(names.end(), std::begin(kNormals), std::end(kNormals));
  for (const Attribute& attribute : mesh.attributes)
    for (const std::string& name : property_names(attribute)) {
      if (std::find(names.begin(), names.end(), name) != names.end())
        throw Error(ErrorCode::bad_input,
                    fmt::format("two attributes have the PLY property name '{}'", name));
      names.push_back(name);
    }
  ByteWriter out(sink);
  out.text("ply\nformat binary_little_endian 1.0\n").text(comment_lines(notes, "comment "));
  out.text(fmt::format("element vertex {}\n", mesh.positions.size()));
  for (const std::string& name : names) out.text("property float ").text(name).text("\n");
  // Most readers expect int, which suffices for 2^31 - 1 vertices.
  const bool wide = mesh.positions.size() > INT32_MAX;
  out.text(fmt::format("element face {}\nproperty list uchar {} vertex_indices\nend_header\n",
                       mesh.triangles.size(), wide ? "uint" : "int"));
  const auto triple = [&](const Vec3f& p) { out.binary(p.x).binary(p.y).binary(p.z); };
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    triple(mesh.positions[v]);
    if (!mesh.normals.empty()) triple(mesh.normals[v]);
    for (const Attribute& attribute : mesh.attributes) {
      const auto arity = static_cast<size_t>(attribute.arity);
      for (size_t k = 0; k < arity; ++k) out.binary(attribute.values[arity * v + k]);
    }
  }
  for (const Triangle& t : mesh.triangles) out.binary(uint8_t{3}).binary(t);
  out.finish();
}

}  // namespace
}  // namespace vug::mesh

VUG_MESH_FORMAT(ply) {
  return mesh_format("ply",
                     "Stanford polygons: positions, normals and every attribute (Cd as red, green, "
                     "blue); read as text or binary of either byte order, written as "
                     "little-endian binary",
                     "turk1994", read_ply, write_ply);
}
