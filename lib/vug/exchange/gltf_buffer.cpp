// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/memory.h>
#include <vug/exchange/gltf_buffer.h>
#include <vug/exchange/names.h>
#include <vug/mesh/rock_weights.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace vug::exchange {
namespace {

constexpr size_t kMostBytes = 0xffffffffu - (1u << 24);  // The rest is reserved for the text.

Vec3f unit(const Vec3f& normal) {
  const float length = normal.length();
  return length > 0 ? normal / length : Vec3f(0, 1, 0);
}

std::string upper(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return text;
}

}  // namespace

GltfBuffer::GltfBuffer(tinygltf::Model& model) : model_(model) { model_.buffers.resize(1); }

void GltfBuffer::require_size(size_t bytes) const {
  const size_t all = model_.buffers[0].data.size() + bytes;
  if (all <= kMostBytes) return;
  throw Error(ErrorCode::too_large,
              fmt::format("a .glb file is limited to 4 GiB, and this scene takes {}",
                          bytes_text(static_cast<double>(all))),
              {}, "use larger voxels, or another format such as usda");
}

int GltfBuffer::view(const void* data, size_t bytes, int target) {
  require_size(bytes);
  std::vector<unsigned char>& all = model_.buffers[0].data;
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = all.size();
  view.byteLength = bytes;
  view.target = target;
  const auto* from = static_cast<const unsigned char*>(data);
  all.insert(all.end(), from, from + bytes);
  all.resize((all.size() + 3) / 4 * 4);
  model_.bufferViews.push_back(std::move(view));
  return static_cast<int>(model_.bufferViews.size()) - 1;
}

int GltfBuffer::accessor(int view, int component, int type, size_t count) {
  tinygltf::Accessor accessor;
  accessor.bufferView = view;
  accessor.componentType = component;
  accessor.type = type;
  accessor.count = count;
  model_.accessors.push_back(std::move(accessor));
  return static_cast<int>(model_.accessors.size()) - 1;
}

int GltfBuffer::floats(const float* values, size_t count, int arity, bool bounds, int target) {
  const auto width = static_cast<size_t>(arity);
  const int type = arity == 1 ? TINYGLTF_TYPE_SCALAR : arity;  // VEC2 is 2, and so on.
  const int made = accessor(view(values, count * width * sizeof(float), target),
                            TINYGLTF_COMPONENT_TYPE_FLOAT, type, count);
  if (!bounds) return made;
  std::vector<double> low(width, kInfinity), high(width, -kInfinity);
  for (size_t i = 0; i < count * width; ++i) {
    const auto value = static_cast<double>(values[i]);
    low[i % width] = std::min(low[i % width], value);
    high[i % width] = std::max(high[i % width], value);
  }
  model_.accessors.back().minValues = low;
  model_.accessors.back().maxValues = high;
  return made;
}

int GltfBuffer::indices(const std::vector<mesh::Triangle>& triangles, size_t vertices) {
  constexpr int kTarget = TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER;
  const size_t count = 3 * triangles.size();
  if (vertices > 0xffff)  // The highest 16-bit index is reserved.
    return accessor(view(triangles.data(), count * sizeof(uint32_t), kTarget),
                    TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR, count);
  std::vector<uint16_t> narrow;
  narrow.reserve(count);
  for (const mesh::Triangle& t : triangles)
    for (const uint32_t corner : t) narrow.push_back(static_cast<uint16_t>(corner));
  return accessor(view(narrow.data(), count * sizeof(uint16_t), kTarget),
                  TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_SCALAR, count);
}

int GltfBuffer::colors(const std::vector<float>& rgb, const std::vector<float>* opacity) {
  const size_t count = rgb.size() / 3;
  const auto whole = [](float share) {
    return static_cast<uint16_t>(std::lround(std::clamp(share, 0.0f, 1.0f) * 65535));
  };
  std::vector<uint16_t> values(4 * count, 0xffff);
  for (size_t i = 0; i < count; ++i) {
    for (size_t c = 0; c < 3; ++c) values[4 * i + c] = whole(rgb[3 * i + c]);
    if (opacity) values[4 * i + 3] = whole((*opacity)[i]);
  }
  const int made =
      accessor(view(values.data(), values.size() * sizeof(uint16_t), TINYGLTF_TARGET_ARRAY_BUFFER),
               TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_VEC4, count);
  model_.accessors.back().normalized = true;
  return made;
}

namespace {

std::vector<float> constant_color(const Prototype& prototype) {
  std::vector<float> out;
  for (size_t i = 0; i < prototype.mesh->positions.size(); ++i)
    for (int c = 0; c < 3; ++c) out.push_back(static_cast<float>(prototype.look.base_color[c]));
  return out;
}

/// The triangles of each rock of the prototype, and last those of none.
std::vector<std::vector<mesh::Triangle>> triangles_by_rock(const Prototype& prototype) {
  std::vector<std::string> names;
  for (const RockLook& rock : prototype.rocks) names.push_back(rock.rock);
  const std::vector<int32_t> of_faces = mesh::face_materials(*prototype.mesh, names);
  std::vector<std::vector<mesh::Triangle>> parts(names.size() + 1);
  for (size_t face = 0; face < of_faces.size(); ++face)
    parts[of_faces[face] < 0 ? names.size() : static_cast<size_t>(of_faces[face])].push_back(
        prototype.mesh->triangles[face]);
  return parts;
}

}  // namespace

tinygltf::Mesh gltf_mesh(const Prototype& prototype,
                         const std::function<int(const Prototype&)>& material_of,
                         GltfBuffer& buffer, std::vector<std::string>& unsupported) {
  constexpr int kTarget = TINYGLTF_TARGET_ARRAY_BUFFER;
  const mesh::Mesh& mesh = *prototype.mesh;
  const size_t vertices = mesh.positions.size();
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  primitive.attributes["POSITION"] =
      buffer.floats(&mesh.positions[0].x, vertices, 3, true, kTarget);
  if (!mesh.normals.empty()) {
    std::vector<Vec3f> normals;
    normals.reserve(vertices);
    for (const Vec3f& normal : mesh.normals) normals.push_back(unit(normal));
    primitive.attributes["NORMAL"] = buffer.floats(&normals[0].x, vertices, 3, false, kTarget);
  }
  const mesh::Attribute* color = mesh::find_attribute(mesh, mesh::kColour, 3);
  const mesh::Attribute* opacity = mesh::find_attribute(mesh, "opacity", 1);
  if (color || opacity)
    primitive.attributes["COLOR_0"] = buffer.colors(
        color ? color->values : constant_color(prototype), opacity ? &opacity->values : nullptr);
  UniqueNames names;
  for (const mesh::Attribute& each : mesh.attributes) {
    if (&each == color)
      continue;
    else if (each.arity <= 4)
      primitive.attributes[fmt::format("_{}", names.unique(upper(each.name)))] =
          buffer.floats(each.values.data(), vertices, each.arity, false, kTarget);
    else
      unsupported.push_back(
          fmt::format("the attribute '{}' of '{}', which has {} numbers per vertex", each.name,
                      prototype.name, each.arity));
  }
  tinygltf::Mesh out;
  out.name = prototype.name;
  const auto add = [&](const std::vector<mesh::Triangle>& triangles, const Prototype& look) {
    if (triangles.empty()) return;
    out.primitives.push_back(primitive);
    out.primitives.back().indices = buffer.indices(triangles, vertices);
    out.primitives.back().material = material_of(look);
  };
  if (prototype.rocks.empty()) {
    add(mesh.triangles, prototype);
    return out;
  }
  const std::vector<std::vector<mesh::Triangle>> parts = triangles_by_rock(prototype);
  for (size_t rock = 0; rock < prototype.rocks.size(); ++rock)
    add(parts[rock], of_rock(prototype, prototype.rocks[rock]));
  add(parts.back(), prototype);
  return out;
}

}  // namespace vug::exchange
