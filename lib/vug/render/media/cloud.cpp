// Fog whose density is a grid: delta tracking finds collisions, ratio tracking what comes through
// (Novak, Georgiev, Hanika, Jarosz 2018, "Monte Carlo methods for volumetric light transport
// simulation", novak2018volumes), brick by brick with a bound of its own for each.
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/render/kind.h>
#include <vug/render/phase.h>
#include <vug/volume/density.h>
#include <vug/volume/io.h>

namespace vug::render {
namespace {

struct DenseCloud {
  std::filesystem::path file;
  std::string grid;
  double extinction = 1;
  Vec3d albedo{0.9, 0.9, 0.9};
  Vec3d emission{0, 0, 0};
  double g = 0.6;

  static void describe(Schema<DenseCloud>& s) {
    s.doc(
         "Fog with the density of a grid: of a .vdb file, or of the volume that it stands on: "
         "medium NAME on VOLUME { kind cloud }.")
        .cite("novak2018volumes")
        .param("file", &DenseCloud::file, {.doc = "A .vdb file with a grid of floats."})
        .param("grid", &DenseCloud::grid, {.doc = "The grid's name; else the first."})
        .param("extinction", &DenseCloud::extinction,
               {.doc = "Collisions per metre where the density is 1.",
                .dimension = Dimension::per_length,
                .min = 0})
        .param("albedo", &DenseCloud::albedo,
               {.doc = "Share of the collisions that scatter.", .min = 0, .max = 1})
        .param("emission", &DenseCloud::emission,
               {.doc = "Radiance (W/sr/m^2) of a cloud that nothing shines through; it glows where "
                       "it is dense.",
                .min = 0})
        .param("g", &DenseCloud::g,
               {.doc = "Mean cosine of scattering; above 0 light keeps its direction.",
                .min = -0.99,
                .max = 0.99});
  }
};

/// A ray in index coordinates, brick by brick.
class Walk {
 public:
  Walk(const volume::Density& density, const Ray& ray, const Segment& segment)
      : density_(density),
        origin_(density.to_index(ray.origin)),
        direction_(density.direction_to_index(ray.direction)),
        t_(segment.begin),
        end_(segment.end) {
    const Vec3f at = index(t_);
    for (int axis = 0; axis < 3; ++axis) {
      const int last = density.bricks()[axis] - 1;
      brick_[axis] =
          std::clamp(static_cast<int>(std::floor(at[axis] / volume::Density::kSize)), 0, last);
      const float d = direction_[axis];
      step_[axis] = d > 0 ? 1 : -1;
      const auto edge = static_cast<float>((brick_[axis] + (d > 0)) * volume::Density::kSize);
      next_[axis] = d != 0 ? (edge - origin_[axis]) / d : kFar;
      apart_[axis] = d != 0 ? volume::Density::kSize / std::fabs(d) : kFar;
    }
  }
  Vec3f index(float t) const { return origin_ + direction_ * t; }

  /// Calls visit(begin, end, most) for the parts of the ray in bricks until it returns false.
  template <class Visit>
  void each(const Visit& visit) {
    while (t_ < end_) {
      int axis = next_.x < next_.y ? 0 : 1;
      if (next_.z < next_[axis]) axis = 2;
      const float leave = std::min(next_[axis], end_);
      if (leave > t_) {
        const float most = density_.most(brick_);
        if (most > 0 && !visit(t_, leave, most)) return;
        t_ = leave;
      }
      brick_[axis] += step_[axis];
      next_[axis] += apart_[axis];
      if (brick_[axis] < 0 || brick_[axis] >= density_.bricks()[axis]) return;
    }
  }

 private:
  const volume::Density& density_;
  Vec3f origin_, direction_, next_{0, 0, 0}, apart_{0, 0, 0};
  Vec3i brick_{0, 0, 0}, step_{0, 0, 0};
  float t_, end_;
};

/// A step to the next possible collision, in units of the mean free path.
float free_path(TrackingNumbers& numbers) {
  return static_cast<float>(-maths::log(1 - static_cast<double>(numbers.next())));
}

class CloudMedium final : public Medium {
 public:
  explicit CloudMedium(const DenseCloud& p)
      : extinction_(static_cast<float>(p.extinction)),
        albedo_(p.albedo),
        glow_(p.emission),
        g_(static_cast<float>(p.g)) {
    if (!p.file.empty())
      fill(std::make_shared<const volume::Density>(volume::read_grid(p.file, p.grid)));
  }

  MediumPtr fitted(const Box3f&) const override { return nullptr; }
  MediumPtr filled(std::shared_ptr<const volume::Density> density) const override {
    auto copy = std::make_shared<CloudMedium>(*this);
    copy->fill(std::move(density));
    return copy;
  }
  bool hollow() const override { return density_ == nullptr; }

  Segment clip(const Ray& ray, float end) const override {
    return bounds_.isEmpty() ? Segment{0, 0} : clipped(bounds_, ray, end);
  }
  float transmittance(const Ray& ray, const Segment& segment,
                      TrackingNumbers& numbers) const override {
    if (segment.empty()) return 1;
    float through = 1;
    Walk walk(*density_, ray, segment);
    float left = free_path(numbers);
    walk.each([&](float t, float end, float most) {
      const float bound = most * extinction_;
      while (left < (end - t) * bound) {
        t += left / bound;
        through *= 1 - density_->at(walk.index(t)) / most;
        if (through < 0.1f) {
          // Dim light goes on by lot: the mean stays.
          if (numbers.next() >= 2 * through) {
            through = 0;
            return false;
          }
          through = 0.5f;
        }
        left = free_path(numbers);
      }
      left -= (end - t) * bound;
      return true;
    });
    return through;
  }
  DistanceSample sample_distance(const Ray& ray, const Segment& segment, float u,
                                 TrackingNumbers& numbers) const override {
    DistanceSample sample;
    if (segment.empty()) return sample;
    Walk walk(*density_, ray, segment);
    float left = static_cast<float>(-maths::log(1 - static_cast<double>(u)));
    walk.each([&](float t, float end, float most) {
      const float bound = most * extinction_;
      while (left < (end - t) * bound) {
        t += left / bound;
        if (numbers.next() * most < density_->at(walk.index(t))) {
          sample = {t, true};
          return false;
        }
        left = free_path(numbers);
      }
      left -= (end - t) * bound;
      return true;
    });
    return sample;
  }
  float extinction(const Vec3f& point) const override {
    return extinction_ * density_->at(density_->to_index(point));
  }
  Rgb albedo(const Vec3f&) const override { return albedo_; }
  float usual_extinction() const override { return usual_; }
  Rgb glow() const override { return glow_; }

  float phase(float cosine) const override { return henyey_greenstein(g_, cosine); }
  Vec3f sample_phase(const Vec3f& travel, const Vec2f& u) const override {
    return sample_henyey_greenstein(g_, travel, u);
  }

 private:
  void fill(std::shared_ptr<const volume::Density> density) {
    density_ = std::move(density);
    bounds_ = density_->bounds();
    const Vec3i n = density_->bricks();
    double sum = 0;
    for (int z = 0; z < n.z; ++z)
      for (int y = 0; y < n.y; ++y)
        for (int x = 0; x < n.x; ++x) sum += static_cast<double>(density_->most({x, y, z}));
    const double bricks = static_cast<double>(n.x) * n.y * n.z;
    usual_ = bricks > 0 ? extinction_ * static_cast<float>(0.5 * sum / bricks) : 0;
  }

  float extinction_;
  Rgb albedo_, glow_;
  float g_, usual_ = 0;
  std::shared_ptr<const volume::Density> density_;
  Box3f bounds_;
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(cloud, medium, MediumPtr, DenseCloud, CloudMedium)
