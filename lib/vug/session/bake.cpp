#include <vug/base/parallel.h>
#include <vug/exchange/channels.h>
#include <vug/mesh/normals.h>
#include <vug/render/placing.h>
#include <vug/session/bake.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::session {
namespace {

/// What varies by less looks the same.
constexpr double kSame = 1.0 / 1024;

/// A triangle of each vertex, as triangle * 3 + corner.
std::vector<uint32_t> corners_of(const mesh::Mesh& mesh) {
  std::vector<uint32_t> out(mesh.positions.size(), UINT32_MAX);
  for (size_t face = 0; face < mesh.triangles.size(); ++face)
    for (size_t k = 0; k < 3; ++k) {
      uint32_t& known = out[mesh.triangles[face][k]];
      if (known == UINT32_MAX) known = static_cast<uint32_t>(3 * face + k);
    }
  return out;
}

class Eye {
 public:
  explicit Eye(const render::Object& object)
      : object_(object),
        mesh_(*object.mesh),
        corners_(corners_of(mesh_)),
        color_(mesh::find_attribute(mesh_, mesh::kColour, 3)) {
    if (mesh_.normals.empty()) normals_ = mesh::vertex_normals(mesh_);
    if (object.looks_by_place && object.placing) placing_ = object.placing.get();
  }

  exchange::Look at(size_t vertex) const {
    render::Surface surface;
    surface.mesh = &mesh_;
    surface.solid = object_.solid.get();
    surface.position = mesh_.positions[vertex];
    surface.shading_normal = mesh_.normals.empty() ? normals_[vertex] : mesh_.normals[vertex];
    if (placing_) {
      const render::Affine place = placing_->at(0);
      surface.placing = placing_;
      surface.looks_by_place = true;
      surface.position = place.point(surface.position);
      surface.shading_normal = render::normalized(place.normal(surface.shading_normal));
    }
    surface.geometric_normal = surface.shading_normal;
    if (color_)
      surface.color = {color_->values[3 * vertex], color_->values[3 * vertex + 1],
                       color_->values[3 * vertex + 2]};
    exchange::Look look;
    if (const uint32_t corner = corners_[vertex]; corner != UINT32_MAX) {
      surface.triangle = corner / 3;
      surface.u = corner % 3 == 1 ? 1 : 0;
      surface.v = corner % 3 == 2 ? 1 : 0;
      if (object_.material) look = object_.material->look(surface);
      if (object_.material && object_.material->shines())
        look.emission = Vec3d(object_.material->emission(surface));
    }
    if (!object_.material) look.base_color = Vec3d(surface.color) * 0.5;
    look.emission += Vec3d(object_.emission);
    return look;
  }

 private:
  const render::Object& object_;
  const mesh::Mesh& mesh_;
  std::vector<uint32_t> corners_;
  std::vector<Vec3f> normals_;
  const mesh::Attribute* color_;
  const render::Placing* placing_ = nullptr;  ///< That the look depends on.
};

double part_of(const exchange::Channel& channel, const exchange::Look& look, int part) {
  return channel.color ? (look.*channel.color)[part] : look.*channel.number;
}

/// The smallest, the largest and the sum of what a channel's parts are.
struct Spread {
  Vec3d low{kInfinity, kInfinity, kInfinity}, high{-kInfinity, -kInfinity, -kInfinity};

  bool varies() const {
    const Vec3d size = high - low;
    return std::max({size.x, size.y, size.z}) > kSame * std::max(1.0, high.length());
  }
};

}  // namespace

Baked bake(const render::Object& object) {
  const Eye eye(object);
  mesh::Mesh out = *object.mesh;
  const size_t vertices = out.positions.size();
  Baked baked;
  if (vertices == 0) return {object.mesh, {}};
  baked.look = eye.at(0);
  std::vector<mesh::Attribute> found;
  for (const exchange::Channel& channel : exchange::channels())
    found.push_back({std::string(channel.attribute), channel.arity(),
                     std::vector<float>(vertices * static_cast<size_t>(channel.arity()))});
  parallel_for(
      vertices,
      [&](size_t v) {
        const exchange::Look look = eye.at(v);
        for (size_t c = 0; c < found.size(); ++c)
          for (int k = 0; k < found[c].arity; ++k)
            found[c].values[v * static_cast<size_t>(found[c].arity) + static_cast<size_t>(k)] =
                static_cast<float>(part_of(exchange::channels()[c], look, k));
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
    if (channel.color)
      baked.look.*channel.color = sum;
    else
      baked.look.*channel.number = sum.x;
    for (mesh::Attribute& own : out.attributes)
      if (own.name == found[c].name && own.name != mesh::kColour)
        own.name = fmt::format("raw_{}", own.name);
    const auto colors =
        std::remove_if(out.attributes.begin(), out.attributes.end(),
                       [&](const mesh::Attribute& own) { return own.name == found[c].name; });
    out.attributes.erase(colors, out.attributes.end());
    if (spread.varies())
      out.attributes.insert(
          channel.attribute == mesh::kColour ? out.attributes.begin() : out.attributes.end(),
          std::move(found[c]));
  }
  baked.mesh = std::make_shared<const mesh::Mesh>(std::move(out));
  return baked;
}

}  // namespace vug::session
