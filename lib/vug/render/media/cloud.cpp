// SPDX-License-Identifier: Apache-2.0
// Medium with a density grid: delta tracking samples collisions, residual ratio tracking estimates
// transmittance (Novak, Georgiev, Hanika, Jarosz 2018, "Monte Carlo methods for volumetric light
// transport simulation", novak2018volumes), with majorants and means per brick (Novak, Selle,
// Jarosz 2014, "Residual ratio tracking for estimating attenuation in participating media",
// novak2014residual). All colours share one extinction, so a coloured albedo is only a weight and
// needs no spectral tracking.
#include <vug/base/diagnostics.h>
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/render/kind.h>
#include <vug/render/lighting/blackbody.h>
#include <vug/render/materials/material_input.h>
#include <vug/render/media/brick_traversal.h>
#include <vug/render/media/phase.h>
#include <vug/volume/io.h>
#include <vug/volume/resampled.h>

#include <fmt/format.h>

namespace vug::render {
namespace {

using Range = volume::MajorantGrid::Range;
/// Cost of passing a brick, relative to one density lookup.
constexpr double kPassing = 0.2;

using DensityPtr = std::shared_ptr<const volume::Density>;

struct CloudParams {
  std::filesystem::path file;
  std::string grid;
  double extinction = 1;
  ColorInput albedo = Vec3d(0.9);
  std::string color_grid;
  Vec3d emission{0, 0, 0};
  NumberInput emission_mask = 1;
  std::string emission_grid;
  std::string temperature_grid;
  NumberInput temperature_mask = 1;
  double temperature = 0;
  double g = 0.6;

  std::string fault() const {
    if (file.empty() && !(color_grid.empty() && emission_grid.empty() && temperature_grid.empty()))
      return "named grids need a 'file' that contains them";
    if (!temperature_grid.empty() && !(temperature > 0))
      return "a temperature grid needs a 'temperature': the kelvin where the grid is 1";
    return "";
  }
  static void describe(Schema<CloudParams>& s);
};

void CloudParams::describe(Schema<CloudParams>& s) {
  using P = CloudParams;
  s.doc(
       "Fog with the density of a grid: of a .vdb file, or of the volume that it is declared on: "
       "medium NAME on VOLUME { kind cloud }.")
      .cite("novak2018volumes")
      .param("file", &P::file, {.doc = "A .vdb file with a grid of floats."})
      .param(
          "grid", &P::grid,
          {.doc = "Name of the density grid; without it, the grid named density, else the first."})
      .param("extinction", &P::extinction,
             {.doc = "Extinction coefficient (1/m) where the density is 1.",
              .dimension = Dimension::per_length,
              .min = 0})
      .param("albedo", &P::albedo,
             {.doc = "Fraction of the collisions that scatter, by colour.", .min = 0, .max = 1})
      .param("color_grid", &P::color_grid,
             {.doc = "A grid of the file whose vectors multiply the albedo: Cd, color."})
      .param(
          "emission", &P::emission,
          {.doc = "Radiance (W/sr/m^2) of an opaque cloud; emission is proportional to the "
                  "density. With an emission_grid: radiance added per metre where the grid is 1.",
           .min = 0})
      .param("emission_mask", &P::emission_mask,
             {.doc = "Factor of all emission.", .min = 0, .max = 1})
      .param(
          "emission_grid", &P::emission_grid,
          {.doc = "A grid of the file with the emission, independent of the density: flame, heat."})
      .param("temperature_grid", &P::temperature_grid,
             {.doc = "A temperature grid of the file. The medium emits as a black body."})
      .param("temperature_mask", &P::temperature_mask,
             {.doc = "Factor of the temperature.", .min = 0, .max = 1})
      .param("temperature", &P::temperature,
             {.doc = "Kelvin where the grid (or without a grid the mask) is 1; use 1 for grids in "
                     "kelvin. 0: no thermal emission.",
              .dimension = Dimension::temperature,
              .min = 0})
      .param("g", &P::g,
             {.doc = "Mean cosine of scattering; above 0 is forward scattering.",
              .min = -0.99,
              .max = 0.99});
}

/// A point in the medium in the form that masks and paints evaluate.
paint::EvalPoint eval_point_at(const Vec3f& point) {
  paint::EvalPoint out;
  out.position = Vec3d(point);
  out.normal = Vec3d(0, 1, 0);
  return out;
}

float value_at(const NumberInput& input, const Vec3f& point) {
  return input.varying ? input.at(eval_point_at(point)) : static_cast<float>(input.constant);
}

/// Grids of one file by name.
class GridFile {
 public:
  explicit GridFile(const CloudParams& p) : file_(p.file), grids_(volume::read(p.file)) {}

  const volume::Grid& find(const std::string& name) const {
    std::vector<std::string> names;
    for (const volume::Grid& grid : grids_) {
      if (grid.name() == name) return grid;
      names.push_back(grid.name());
    }
    throw Error(ErrorCode::bad_input,
                fmt::format("'{}' has no grid named '{}'", file_.string(), name), {},
                suggestion(name, names));
  }
  const volume::Grid& density(const std::string& name) const {
    if (!name.empty()) return find(name);
    if (grids_.empty())
      throw Error(ErrorCode::bad_input, fmt::format("'{}' has no grid", file_.string()));
    for (const volume::Grid& grid : grids_)
      if (grid.name() == "density") return grid;
    return grids_.front();
  }
  DensityPtr read(const std::string& name, int part = 0) const {
    return name.empty() ? nullptr : std::make_shared<const volume::Density>(find(name), part);
  }

 private:
  std::filesystem::path file_;
  std::vector<volume::Grid> grids_;
};

class CloudMedium final : public Medium {
 public:
  explicit CloudMedium(const CloudParams& p)
      : p_(p), extinction_(static_cast<float>(p.extinction)) {
    if (p.file.empty()) return;
    const GridFile file(p);
    heat_ = file.read(p.temperature_grid);
    flames_ = file.read(p.emission_grid);
    if (!p.color_grid.empty())
      for (int part = 0; part < 3; ++part)
        colour_[static_cast<size_t>(part)] = file.read(p.color_grid, part);
    fill(std::make_shared<const volume::Density>(file.density(p.grid)));
  }

  MediumPtr with_bounds(const Box3f&) const override { return nullptr; }
  MediumPtr with_density(DensityPtr density) const override {
    auto copy = std::make_shared<CloudMedium>(*this);
    copy->fill(std::move(density));
    return copy;
  }
  bool has_grids() const override { return true; }
  std::optional<MediumData> as_data(const volume::Grid* density) const override {
    std::optional<GridFile> file;
    if (!p_.file.empty()) file.emplace(p_);
    const volume::Grid body = file ? file->density(p_.grid) : *density;
    MediumData data{{p_.extinction, p_.albedo.constant, p_.g, p_.emission, hot() ? 1.0 : 0.0},
                    {body.named("density")}};
    if (p_.albedo.varying || colour_[0]) {
      data.medium.albedo = Vec3d(1.0);
      data.grids.push_back(volume::resampled_vectors(body, [&](const Vec3f& p) {
                             return albedo(p);
                           }).named("color"));
    }
    if (hot()) {
      const volume::Grid& where = heat_ ? file->find(p_.temperature_grid) : body;
      data.grids.push_back(
          volume::resampled(where, [&](const Vec3f& p) { return kelvin(p); }).named("temperature"));
    }
    if (flames_ || (p_.emission_mask.varying && has_emission())) {
      const volume::Grid& where = flames_ ? file->find(p_.emission_grid) : body;
      const auto burning = [&](const Vec3f& p) {
        return emission_factor(p) * (flames_ ? flames_->at_world(p) : extinction(p));
      };
      data.grids.push_back(volume::resampled(where, burning).named("flame"));
    } else {
      data.medium.emission *= p_.emission_mask.constant;
      data.medium.heat *= p_.emission_mask.constant;
    }
    return data;
  }
  bool needs_density() const override { return density_ == nullptr; }

  Segment clip(const Ray& ray, float end) const override {
    return bounds_.isEmpty() ? Segment{0, 0} : clip_to_box(bounds_, ray, end);
  }
  float transmittance(const Ray& ray, const Segment& whole, TrackingRng& numbers) const override {
    const Segment segment = within(*density_, ray, whole);
    if (segment.empty()) return 1;
    // The mean density of each brick is integrated exactly, the residual is tracked.
    float through = 1, known = 0;
    BrickTraversal walk(*density_, *bricks_, ray, segment);
    float left = free_path(numbers.next());
    for (BrickTraversal::Interval step; walk.next(step);) {
      const Range& range = step.range;
      known += (step.end - step.begin) * range.mean;
      const float most = std::max(range.max - range.mean, range.mean - range.min),
                  bound = most * extinction_;
      float t = step.begin;
      while (left < (step.end - t) * bound) {
        t += left / bound;
        through *=
            1 - (density_->stochastic_at(walk.index(t), numbers.triple()) - range.mean) / most;
        if (through < 0.1f) {
          // Russian roulette for low transmittance; the estimate stays unbiased.
          if (numbers.next() >= 2 * through) return 0;
          through = 0.5f;
        }
        left = free_path(numbers.next());
      }
      left -= (step.end - t) * bound;
    }
    return through * attenuation(known);
  }
  DistanceSample sample_distance(const Ray& ray, const Segment& whole, float u,
                                 std::span<ScatterPoint> scatter_points,
                                 TrackingRng& numbers) const override {
    for (ScatterPoint& point : scatter_points) point.transmittance = 1;
    const Segment segment = within(*density_, ray, whole);
    if (segment.empty()) return {};
    BrickTraversal walk(*density_, *bricks_, ray, segment);
    float known = 0, done = -kFar, left = free_path(u);
    for (BrickTraversal::Interval step; walk.next(step); done = step.end) {
      const Range& range = step.range;
      const auto known_to = [&](float t) {
        return known + std::max(t - step.begin, 0.0f) * range.mean;
      };
      const float bound = range.max * extinction_;
      float t = step.begin;
      while (left < (step.end - t) * bound) {
        t += left / bound;
        left = free_path(numbers.next());
        const float density = density_->stochastic_at(walk.index(t), numbers.triple());
        const bool collides = numbers.next() * range.max < density;
        for (ScatterPoint& point : scatter_points) {
          if (!(point.distance > t)) continue;
          point.transmittance *= 1 - (density - range.mean) / range.max;
          if (collides)
            point.transmittance *=
                attenuation(known_to(t)) * transmittance(ray, {t, point.distance}, numbers);
        }
        if (collides) {
          for (ScatterPoint& point : scatter_points)
            if (point.distance > done && point.distance <= t)
              point.transmittance *= attenuation(known_to(point.distance));
          return {t, true};
        }
      }
      left -= (step.end - t) * bound;
      for (ScatterPoint& point : scatter_points)
        if (point.distance > done && point.distance <= step.end)
          point.transmittance *= attenuation(known_to(point.distance));
      known = known_to(step.end);
    }
    for (ScatterPoint& point : scatter_points)
      if (point.distance > done) point.transmittance *= attenuation(known);
    return {};
  }
  float extinction(const Vec3f& point) const override {
    return extinction_ * density_->at(density_->to_index(point));
  }
  void prefetch(const Vec3f& point) const override {
    density_->prefetch(density_->to_index(point));
  }
  Rgb albedo(const Vec3f& point) const override {
    const Rgb own =
        p_.albedo.varying ? p_.albedo.at(eval_point_at(point)) : Rgb(p_.albedo.constant);
    if (!colour_[0]) return own;
    Rgb colour;
    for (int c = 0; c < 3; ++c)
      colour[c] = std::min(colour_[static_cast<size_t>(c)]->at_world(point), 1.0f);
    return own * colour;
  }
  float typical_extinction() const override { return typical_; }

  Rgb emission(const Vec3f& point) const override {
    return flames_ ? Rgb(0.0f) : emitted_radiance(point);
  }
  bool is_emissive() const override { return flames_ != nullptr; }
  /// Samples one point in proportion to the bricks' majorants, and weights it by the transmittance
  /// up to it.
  Rgb sample_emission(const Ray& ray, const Segment& whole, TrackingRng& numbers) const override {
    const Segment segment = within(*flames_, ray, whole);
    if (segment.empty()) return Rgb(0.0f);
    float all = 0;
    BrickTraversal::Interval step;
    for (BrickTraversal walk(*flames_, flames_->majorants().front(), ray, segment);
         walk.next(step);)
      all += (step.end - step.begin) * step.range.max;
    float left = numbers.next() * all, distance = -1, bound = 0;
    BrickTraversal walk(*flames_, flames_->majorants().front(), ray, segment);
    while (left > 0 && walk.next(step)) {
      distance = std::min(step.begin + left / step.range.max, step.end);
      bound = step.range.max;
      left -= (step.end - step.begin) * step.range.max;
    }
    if (!(distance >= 0)) return Rgb(0.0f);
    const float flame = flames_->at(walk.index(distance));
    if (!(flame > 0)) return Rgb(0.0f);
    const float clear = transmittance(ray, {whole.begin, distance}, numbers);
    return emitted_radiance(ray.at(distance)) * (flame * clear * all / bound);
  }

  float phase(float cosine) const override {
    return henyey_greenstein(static_cast<float>(p_.g), cosine);
  }
  Vec3f sample_phase(const Vec3f& travel, const Vec2f& u) const override {
    return sample_henyey_greenstein(static_cast<float>(p_.g), travel, u);
  }

 private:
  /// Transmittance from the integral of density along the ray.
  float attenuation(float way) const {
    return static_cast<float>(maths::exp(-static_cast<double>(way * extinction_)));
  }
  /// The part of a segment in which a grid has values.
  Segment within(const volume::Density& grid, const Ray& ray, const Segment& whole) const {
    if (grid.majorants().empty()) return {0, 0};
    if (!flames_) return whole;  // then the medium is bounded by its density
    if (grid.bounds().isEmpty()) return {0, 0};
    const Segment part = clip_to_box(grid.bounds(), ray, whole.end);
    return {std::max(part.begin, whole.begin), part.end};
  }
  /// Emission before multiplication by extinction or flame.
  Rgb emitted_radiance(const Vec3f& point) const {
    if (!has_emission()) return Rgb(0.0f);
    const float part = emission_factor(point);
    if (!(part > 0)) return Rgb(0.0f);
    Rgb sum(p_.emission);
    if (hot()) sum += thermal_radiance(kelvin(point));
    return sum * part;
  }
  bool hot() const { return p_.temperature > 0; }
  bool has_emission() const { return hot() || p_.emission != Vec3d(0); }
  /// Factor of the emission at a point.
  float emission_factor(const Vec3f& point) const { return value_at(p_.emission_mask, point); }
  float kelvin(const Vec3f& point) const {
    const float own = static_cast<float>(p_.temperature) * value_at(p_.temperature_mask, point);
    return heat_ ? own * heat_->at_world(point) : own;
  }
  void fill(DensityPtr density) {
    density_ = std::move(density);
    bounds_ = density_->bounds();
    if (flames_ && !flames_->bounds().isEmpty()) bounds_.extendBy(flames_->bounds());
    bricks_ = nullptr, typical_ = 0;
    const std::vector<volume::MajorantGrid>& bricks = density_->majorants();
    if (bricks.empty()) return;
    const double voxels = static_cast<double>(density_->size().x) *
                          static_cast<double>(density_->size().y) *
                          static_cast<double>(density_->size().z);
    typical_ = extinction_ * static_cast<float>(0.5 * bricks.front().bound() / voxels);
    // Large bricks are fewer to traverse, small bricks have tighter majorants and so need fewer
    // density lookups.
    const double voxel = 1 / static_cast<double>(length(density_->direction_to_index({1, 0, 0})));
    double least = 0;
    for (const volume::MajorantGrid& each : bricks) {
      const double looks = static_cast<double>(extinction_) * each.bound() / voxels;
      const double cost = looks + kPassing / (voxel * each.size());
      if (!bricks_ || cost < least) bricks_ = &each, least = cost;
    }
  }

  CloudParams p_;
  float extinction_, typical_ = 0;
  DensityPtr density_, heat_, flames_;
  const volume::MajorantGrid* bricks_ =
      nullptr;  ///< Bricks of the size that is cheapest to traverse.
  std::array<DensityPtr, 3> colour_;
  Box3f bounds_;
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(cloud, medium, MediumPtr, CloudParams, CloudMedium)
