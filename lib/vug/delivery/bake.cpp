// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/delivery/bake.h>
#include <vug/delivery/cutout_mesh.h>
#include <vug/delivery/material_probe.h>
#include <vug/exchange/channels.h>
#include <vug/mesh/rock_weights.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::delivery {
namespace {

/// Smaller variations are treated as constant.
constexpr double kSame = 1.0 / 1024;

double component_of(const exchange::Channel& channel, const exchange::Look& look, int part) {
  return channel.color ? (look.*channel.color)[part] : look.*channel.number;
}

/// The minimum and maximum of the components of a channel.
struct Spread {
  Vec3d low{kInfinity, kInfinity, kInfinity}, high{-kInfinity, -kInfinity, -kInfinity};

  bool varies() const {
    const Vec3d size = high - low;
    return std::max({size.x, size.y, size.z}) > kSame * std::max(1.0, high.length());
  }
};

/// Whether the channel may vary; memory is reserved only for such channels.
bool may_vary(const render::Object& object, const exchange::Channel& channel, bool solid) {
  const render::Material* material = object.material.get();
  if (channel.number == &exchange::Look::opacity) return material && material->cut_out() && !solid;
  if (channel.color == &exchange::Look::through) return material && material->thin();
  if (channel.color == &exchange::Look::emission) return material && material->is_emissive();
  return true;
}

/// Vertices of a rock from which its mean look is computed.
constexpr size_t kLookSamples = 16384;

/// For each rock with triangles the mean of the looks at their corners, weighted by the rock. Where
/// a rock is pure, its mean contains no other, also of properties that no channel carries.
template <class LookAt>
std::vector<exchange::RockLook> rock_looks(const mesh::Mesh& mesh, const LookAt& look_at) {
  const std::vector<std::string> names = mesh::rock_materials(mesh);
  std::vector<exchange::RockLook> out;
  if (names.empty()) return out;
  const std::vector<int32_t> of_faces = mesh::face_materials(mesh, names);
  for (size_t rock = 0; rock < names.size(); ++rock) {
    std::vector<uint32_t> corners;
    for (size_t face = 0; face < of_faces.size(); ++face)
      if (of_faces[face] == static_cast<int32_t>(rock)) corners.push_back(mesh.triangles[face][0]);
    if (corners.empty()) continue;
    const mesh::Attribute& weights =
        *mesh::find_attribute(mesh, mesh::weight_attribute(names[rock]), 1);
    const size_t step = (corners.size() + kLookSamples - 1) / kLookSamples;
    exchange::RockLook mean{names[rock], look_at(corners[0])};
    double sum = 0;
    for (size_t i = 0; i < corners.size(); i += step) {
      const auto weight = static_cast<double>(weights.values[corners[i]]);
      if (weight <= 0) continue;
      sum += weight;
      mean.look = exchange::blend(mean.look, look_at(corners[i]), weight / sum);
    }
    out.push_back(std::move(mean));
  }
  return out;
}

/// Bakes the mesh without cutting it. `solid`: the opacity is 1 everywhere.
BakeResult bake_uncut(const render::Object& object, bool solid) {
  const MaterialProbe probe(object);
  mesh::Mesh out = *object.mesh;
  const size_t vertices = out.positions.size();
  BakeResult baked;
  if (vertices == 0) return {object.mesh, {}};
  const auto look_at = [&](size_t vertex) {
    exchange::Look look = probe.at(vertex);
    if (solid) look.opacity = 1;
    return look;
  };
  baked.look = look_at(0);
  std::vector<mesh::Attribute> found;
  for (const exchange::Channel& channel : exchange::channels()) {
    const bool asked = may_vary(object, channel, solid);
    found.push_back(
        {std::string(channel.attribute), channel.arity(),
         std::vector<float>(asked ? vertices * static_cast<size_t>(channel.arity()) : 0)});
  }
  parallel_for(
      vertices,
      [&](size_t v) {
        const exchange::Look look = look_at(v);
        for (size_t c = 0; c < found.size(); ++c)
          for (int k = 0; k < found[c].arity && !found[c].values.empty(); ++k)
            found[c].values[v * static_cast<size_t>(found[c].arity) + static_cast<size_t>(k)] =
                static_cast<float>(component_of(exchange::channels()[c], look, k));
      },
      256);
  for (size_t c = 0; c < found.size(); ++c) {
    const exchange::Channel& channel = exchange::channels()[c];
    const auto arity = static_cast<size_t>(found[c].arity);
    Spread spread;
    Vec3d sum(0.0);
    for (size_t i = 0; i < found[c].values.size(); ++i) {
      const auto k = static_cast<int>(i % arity);
      const auto value = static_cast<double>(found[c].values[i]);
      spread.low[k] = std::min(spread.low[k], value);
      spread.high[k] = std::max(spread.high[k], value);
      sum[k] += value;
    }
    for (int k = static_cast<int>(arity); k < 3; ++k) spread.low[k] = spread.high[k] = 0;
    sum /= static_cast<double>(vertices);
    const bool asked = !found[c].values.empty();
    if (asked && channel.color) baked.look.*channel.color = sum;
    if (asked && channel.number) baked.look.*channel.number = sum.x;
    for (mesh::Attribute& own : out.attributes)
      if (own.name == found[c].name && own.name != mesh::kColour)
        own.name = fmt::format("raw_{}", own.name);
    const auto colors =
        std::remove_if(out.attributes.begin(), out.attributes.end(),
                       [&](const mesh::Attribute& own) { return own.name == found[c].name; });
    out.attributes.erase(colors, out.attributes.end());
    if (asked && spread.varies())
      out.attributes.insert(
          channel.attribute == mesh::kColour ? out.attributes.begin() : out.attributes.end(),
          std::move(found[c]));
  }
  baked.rocks = rock_looks(*object.mesh, look_at);
  if (object.flat) out.normals.clear();
  baked.mesh = std::make_shared<const mesh::Mesh>(std::move(out));
  return baked;
}

}  // namespace

BakeResult bake(const render::Object& object) {
  std::optional<mesh::Mesh> kept = cutout_mesh(object);
  if (!kept) return bake_uncut(object, false);
  render::Object cut = object;
  cut.mesh = std::make_shared<const mesh::Mesh>(std::move(*kept));
  return bake_uncut(cut, true);
}

}  // namespace vug::delivery
