// SPDX-License-Identifier: Apache-2.0
#include <vug/render/lobes/albedo.h>
#include <vug/render/lobes/microfacet.h>

#include <map>
#include <memory>
#include <mutex>

namespace vug::render {
namespace {

constexpr int kCosines = static_cast<int>(AlbedoTable::kCosines);
constexpr int kRoughnesses = static_cast<int>(AlbedoTable::kRoughnesses);

/// Nodes are denser at grazing angles.
float node_cosine(size_t i) {
  const float x = static_cast<float>(i) / (kCosines - 1);
  return std::max(x * x, 1e-4f);
}
float node_roughness(size_t j) {
  return kMinRoughness + (1 - kMinRoughness) * static_cast<float>(j) / (kRoughnesses - 1);
}

/// Position of a value between two nodes.
struct NodePosition {
  size_t at;
  float share;
  NodePosition(float x, int nodes) {
    const float place = std::clamp(x, 0.0f, 1.0f) * static_cast<float>(nodes - 1);
    const int node = std::min(static_cast<int>(place), nodes - 2);
    at = static_cast<size_t>(node);
    share = place - static_cast<float>(node);
  }
  template <class Row>
  float in(const Row& row) const {
    return row[at] + (row[at + 1] - row[at]) * share;
  }
};
/// Between nodes the losses are linear in the slope width, the square of the roughness.
NodePosition roughness_position(float roughness) {
  NodePosition place((roughness - kMinRoughness) / (1 - kMinRoughness), kRoughnesses);
  const float low = node_roughness(place.at), high = node_roughness(place.at + 1);
  const float r = std::clamp(roughness, low, high);
  place.share = (r * r - low * low) / (high * high - low * low);
  return place;
}

template <class Value>
float mean_over_cosines(const Value& value) {
  constexpr int kSteps = 512;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const float c = (static_cast<float>(i) + 0.5f) / kSteps;
    sum += static_cast<double>(2 * c * value(c)) / kSteps;
  }
  return static_cast<float>(sum);
}

/// Sets the means of value(cosine, roughness) at the nodes of roughness.
template <class Value>
void find_means(AlbedoTable& table, const Value& value) {
  for (size_t j = 0; j < table.means.size(); ++j)
    table.means[j] = mean_over_cosines([&](float c) { return value(c, node_roughness(j)); });
}

/// Mean of term(out, h, ggx) over the visible normals, for each node.
template <class Term>
AlbedoTable make_table(const Term& term) {
  // A Fibonacci lattice over half of the azimuths; the other half is symmetric.
  constexpr int kPoints = 1597, kStep = 987;
  AlbedoTable table;
  for (size_t j = 0; j < table.values.size(); ++j) {
    const Ggx ggx(node_roughness(j));
    for (size_t i = 0; i < table.values[j].size(); ++i) {
      const Vec3f out = direction_at(node_cosine(i), 0);
      double sum = 0;
      for (int k = 0; k < kPoints; ++k) {
        const Vec2f u((static_cast<float>(k) + 0.5f) / kPoints,
                      0.5f * (static_cast<float>(k * kStep % kPoints) + 0.5f) / kPoints);
        sum += static_cast<double>(term(out, ggx.sample(out, u), ggx));
      }
      table.values[j][i] = static_cast<float>(sum / kPoints);
    }
  }
  find_means(table, [&](float c, float r) { return table.at(c, r); });
  return table;
}

float reflected(const Vec3f& out, const Vec3f& h, const Ggx& ggx) {
  const Vec3f in = h * (2 * dot(out, h)) - out;
  return in.z > 0 ? ggx.g2_over_g1(out, in) : 0;
}

float transmitted(const Vec3f& out, const Vec3f& h, const Ggx& ggx, float ior) {
  const float c = dot(out, h), k = 1 - (1 - c * c) / (ior * ior);
  if (!(k > 0)) return 0;
  const Vec3f in = h * (c / ior - std::sqrt(k)) - out * (1 / ior);
  return in.z < 0 ? ggx.g2_over_g1(out, in) : 0;
}

AlbedoTable make_losses(float ior) {
  return make_table([&](const Vec3f& out, const Vec3f& h, const Ggx& ggx) {
    const float f = fresnel(dot(out, h), ior);
    return 1 - f * reflected(out, h, ggx) - (f < 1 ? (1 - f) * transmitted(out, h, ggx, ior) : 0);
  });
}

/// Tables by index; they are never released.
template <class Table, class Make>
const Table& cached(float ior, const Make& make) {
  static std::mutex mutex;
  static std::map<float, std::unique_ptr<const Table>> tables;
  const std::lock_guard<std::mutex> lock(mutex);
  std::unique_ptr<const Table>& table = tables[ior];
  if (!table) table = make();
  return *table;
}

}  // namespace

float AlbedoTable::at(float cosine, float roughness) const {
  const NodePosition r = roughness_position(roughness);
  const NodePosition c(std::sqrt(std::max(cosine, 0.0f)), kCosines);
  const float low = c.in(values[r.at]);
  return low + (c.in(values[r.at + 1]) - low) * r.share;
}
float AlbedoTable::mean(float roughness) const { return roughness_position(roughness).in(means); }

const AlbedoTable& facet_albedo() {
  static const AlbedoTable table = make_table(reflected);
  return table;
}

float InterfaceTable::Tables::albedo(float ior, float cosine, float roughness) const {
  const float smooth = fresnel(cosine, ior) * facet_albedo().at(cosine, roughness);
  return std::clamp(smooth + more.at(cosine, roughness), 0.0f, 1.0f);
}

InterfaceTable::Tables InterfaceTable::make_tables(float ior) {
  Tables tables;
  tables.more = make_table([&](const Vec3f& out, const Vec3f& h, const Ggx& ggx) {
    return (fresnel(dot(out, h), ior) - fresnel(out.z, ior)) * reflected(out, h, ggx);
  });
  find_means(tables.whole, [&](float c, float r) { return tables.albedo(ior, c, r); });
  return tables;
}

InterfaceTable::InterfaceTable(float ior)
    : ior_(ior),
      mean_fresnel_(mean_over_cosines([&](float c) { return fresnel(c, ior); })),
      tables_([ior] { return make_tables(ior); }) {}
const InterfaceTable& InterfaceTable::of(float ior) {
  return cached<InterfaceTable>(
      ior, [&] { return std::unique_ptr<const InterfaceTable>(new InterfaceTable(ior)); });
}
float InterfaceTable::albedo(float cosine, float roughness) const {
  return tables_->albedo(ior_, cosine, roughness);
}

DielectricTable::DielectricTable(float ior)
    : outside_([ior] { return make_losses(ior); }),
      inside_([ior] { return make_losses(1 / ior); }) {}
const DielectricTable& DielectricTable::of(float ior) {
  return cached<DielectricTable>(
      ior, [&] { return std::unique_ptr<const DielectricTable>(new DielectricTable(ior)); });
}

}  // namespace vug::render
