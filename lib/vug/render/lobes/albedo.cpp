#include <vug/render/lobes/albedo.h>
#include <vug/render/lobes/microfacet.h>

#include <map>
#include <memory>
#include <mutex>

namespace vug::render {
namespace {

constexpr int kCosines = static_cast<int>(AlbedoSheet::kCosines);
constexpr int kRoughnesses = static_cast<int>(AlbedoSheet::kRoughnesses);

/// Nodes lie dense at grazing angles.
float node_cosine(size_t i) {
  const float x = static_cast<float>(i) / (kCosines - 1);
  return std::max(x * x, 1e-4f);
}
float node_roughness(size_t j) {
  return kSmoothest + (1 - kSmoothest) * static_cast<float>(j) / (kRoughnesses - 1);
}

/// Where a value lies between nodes.
struct Place {
  size_t at;
  float share;
  Place(float x, int nodes) {
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
/// Between nodes the losses grow with the width of the slopes, the square of the roughness.
Place roughness_place(float roughness) {
  Place place((roughness - kSmoothest) / (1 - kSmoothest), kRoughnesses);
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

/// Means of what `value` tells at the nodes of roughness.
template <class Value>
void find_means(AlbedoSheet& sheet, const Value& value) {
  for (size_t j = 0; j < sheet.means.size(); ++j)
    sheet.means[j] = mean_over_cosines([&](float c) { return value(c, node_roughness(j)); });
}

/// Mean of term(out, h, ggx) over the facets that are seen, for each node.
template <class Term>
AlbedoSheet make_sheet(const Term& term) {
  // A lattice of Fibonacci numbers over half of the way round, the other half being its mirror.
  constexpr int kPoints = 1597, kStep = 987;
  AlbedoSheet sheet;
  for (size_t j = 0; j < sheet.values.size(); ++j) {
    const Ggx ggx(node_roughness(j));
    for (size_t i = 0; i < sheet.values[j].size(); ++i) {
      const Vec3f out = direction_at(node_cosine(i), 0);
      double sum = 0;
      for (int k = 0; k < kPoints; ++k) {
        const Vec2f u((static_cast<float>(k) + 0.5f) / kPoints,
                      0.5f * (static_cast<float>(k * kStep % kPoints) + 0.5f) / kPoints);
        sum += static_cast<double>(term(out, ggx.sample(out, u), ggx));
      }
      sheet.values[j][i] = static_cast<float>(sum / kPoints);
    }
  }
  find_means(sheet, [&](float c, float r) { return sheet.at(c, r); });
  return sheet;
}

float reflected(const Vec3f& out, const Vec3f& h, const Ggx& ggx) {
  const Vec3f in = h * (2 * dot(out, h)) - out;
  return in.z > 0 ? ggx.unshadowed(out, in) : 0;
}

float let_through(const Vec3f& out, const Vec3f& h, const Ggx& ggx, float ior) {
  const float c = dot(out, h), k = 1 - (1 - c * c) / (ior * ior);
  if (!(k > 0)) return 0;
  const Vec3f in = h * (c / ior - std::sqrt(k)) - out * (1 / ior);
  return in.z < 0 ? ggx.unshadowed(out, in) : 0;
}

AlbedoSheet make_losses(float ior) {
  return make_sheet([&](const Vec3f& out, const Vec3f& h, const Ggx& ggx) {
    const float f = fresnel(dot(out, h), ior);
    return 1 - f * reflected(out, h, ggx) - (f < 1 ? (1 - f) * let_through(out, h, ggx, ior) : 0);
  });
}

/// Tables by index; they stay.
template <class Table, class Make>
const Table& kept(float ior, const Make& make) {
  static std::mutex mutex;
  static std::map<float, std::unique_ptr<const Table>> tables;
  const std::lock_guard<std::mutex> lock(mutex);
  std::unique_ptr<const Table>& table = tables[ior];
  if (!table) table = make();
  return *table;
}

}  // namespace

float AlbedoSheet::at(float cosine, float roughness) const {
  const Place r = roughness_place(roughness);
  const Place c(std::sqrt(std::max(cosine, 0.0f)), kCosines);
  const float low = c.in(values[r.at]);
  return low + (c.in(values[r.at + 1]) - low) * r.share;
}
float AlbedoSheet::mean(float roughness) const { return roughness_place(roughness).in(means); }

const AlbedoSheet& facet_albedo() {
  static const AlbedoSheet sheet = make_sheet(reflected);
  return sheet;
}

FaceTable::FaceTable(float ior)
    : ior_(ior), mean_fresnel_(mean_over_cosines([&](float c) { return fresnel(c, ior); })) {
  more_ = make_sheet([&](const Vec3f& out, const Vec3f& h, const Ggx& ggx) {
    return (fresnel(dot(out, h), ior) - fresnel(out.z, ior)) * reflected(out, h, ggx);
  });
  find_means(whole_, [&](float c, float r) { return albedo(c, r); });
}
const FaceTable& FaceTable::of(float ior) {
  return kept<FaceTable>(ior, [&] { return std::unique_ptr<const FaceTable>(new FaceTable(ior)); });
}
float FaceTable::albedo(float cosine, float roughness) const {
  const float smooth = fresnel(cosine, ior_) * facet_albedo().at(cosine, roughness);
  return std::clamp(smooth + more_.at(cosine, roughness), 0.0f, 1.0f);
}

const GlassTable& GlassTable::of(float ior) {
  return kept<GlassTable>(ior, [&] {
    auto table = std::make_unique<GlassTable>();
    table->outside = make_losses(ior), table->inside = make_losses(1 / ior);
    return table;
  });
}

}  // namespace vug::render
