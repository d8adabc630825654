// A sky from a lat-long picture, sampled by brightness: marginal and conditional tables as in
// Pharr, Jakob, Humphreys 2023, "Physically based rendering", section 12.5.
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/image/io.h>
#include <vug/render/kind.h>
#include <vug/render/sampling.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::render {
namespace {

struct SkyImage {
  std::filesystem::path file;
  double gain = 1;
  double turn = 0;

  static void describe(Schema<SkyImage>& s) {
    s.doc("A sky from a lat-long picture: up is y, the middle column lies towards -z.")
        .cite("pharr2023pbr")
        .param("file", &SkyImage::file,
               {.doc = "Picture, linear (EXR, HDR) or sRGB (PNG).", .required = true})
        .param("gain", &SkyImage::gain, {.doc = "Factor on the picture's values.", .min = 0})
        .param("turn", &SkyImage::turn,
               {.doc = "Turns the sky about the y axis, to the left seen from above.",
                .dimension = Dimension::angle});
  }
};

/// Cumulative sums of non-negative weights, from 0 to 1.
std::vector<float> cumulative(const std::vector<double>& weights, double& total) {
  std::vector<float> table(weights.size() + 1, 0);
  total = 0;
  std::vector<double> sums;
  for (const double w : weights) sums.push_back(total += w);
  for (size_t i = 0; i < weights.size(); ++i)
    table[i + 1] = total > 0 ? static_cast<float>(sums[i] / total)
                             : static_cast<float>(i + 1) / static_cast<float>(weights.size());
  table.back() = 1;
  return table;
}

/// The cell of `u`, and how far in it lies; its probability.
struct Cell {
  size_t index;
  float offset, probability;
};
Cell find_cell(const float* table, size_t cells, float u) {
  const float* above = std::upper_bound(table + 1, table + cells, u);
  const auto index = static_cast<size_t>(above - table) - 1;
  const float p = table[index + 1] - table[index];
  return {index, p > 0 ? std::clamp((u - table[index]) / p, 0.0f, 0.99999994f) : 0.5f, p};
}

class SkyImageLight final : public Light {
 public:
  explicit SkyImageLight(const SkyImage& p) : turn_(static_cast<float>(p.turn / (2 * kPi))) {
    turn_ -= std::floor(turn_);
    const image::Image picture = image::read(p.file, {.linear = true}).select({"R", "G", "B"});
    width_ = static_cast<size_t>(picture.width);
    height_ = static_cast<size_t>(picture.height);
    for (size_t i = 0; i < width_ * height_; ++i) {
      Rgb c(picture.pixels[3 * i], picture.pixels[3 * i + 1], picture.pixels[3 * i + 2]);
      for (int k = 0; k < 3; ++k) {
        if (!std::isfinite(c[k]))
          throw Error(ErrorCode::bad_input,
                      fmt::format("the sky picture '{}' holds values that are not finite",
                                  p.file.string()));
        c[k] = std::max(0.0f, c[k]) * static_cast<float>(p.gain);
      }
      texels_.push_back(c);
    }
    build_tables();
  }

  LightSample sample(const LitPoint&, const Vec2f& u) const override {
    LightSample s;
    const Cell row = find_cell(rows_.data(), height_, u.y);
    const Cell column = find_cell(columns_.data() + row.index * (width_ + 1), width_, u.x);
    const float v = (static_cast<float>(row.index) + row.offset) / static_cast<float>(height_);
    const float x = (static_cast<float>(column.index) + column.offset) / static_cast<float>(width_);
    s.direction = direction(x, v);
    s.distance = kFar;
    s.pdf = density(row.probability * column.probability, v);
    return s;
  }
  float pdf(const LitPoint&, const Vec3f& direction) const override {
    const Vec2f place = locate(direction);
    const size_t row = index_of(place.y, height_), column = index_of(place.x, width_);
    const float* table = columns_.data() + row * (width_ + 1);
    return density((rows_[row + 1] - rows_[row]) * (table[column + 1] - table[column]), place.y);
  }
  float importance(const LitPoint&) const override { return importance_; }
  float importance_along(const Ray&, float, float) const override { return importance_; }
  bool is_sky() const override { return true; }

  float mean_luminance() const override { return mean_luminance_; }
  Rgb escape_radiance(const Vec3f& direction) const override {
    const Vec2f place = locate(direction);
    const float x = place.x * static_cast<float>(width_) - 0.5f;
    const float y = place.y * static_cast<float>(height_) - 0.5f;
    const float fx = std::floor(x), fy = std::floor(y), ax = x - fx, ay = y - fy;
    const long ix = static_cast<long>(fx), iy = static_cast<long>(fy);
    return (texel(ix, iy) * (1 - ax) + texel(ix + 1, iy) * ax) * (1 - ay) +
           (texel(ix, iy + 1) * (1 - ax) + texel(ix + 1, iy + 1) * ax) * ay;
  }

 private:
  static size_t index_of(float place, size_t count) {
    return std::min(static_cast<size_t>(place * static_cast<float>(count)), count - 1);
  }
  const Rgb& texel(long x, long y) const {
    const long w = static_cast<long>(width_), h = static_cast<long>(height_);
    return texels_[static_cast<size_t>(std::clamp(y, 0l, h - 1) * w + ((x % w) + w) % w)];
  }
  /// Picture coordinates in [0, 1]^2, row 0 straight up.
  Vec3f direction(float x, float v) const {
    const SinCos across = sincos_turns(x - 0.5f - turn_), down = sincos_turns(0.5f * v);
    return {down.sin * across.sin, down.cos, -down.sin * across.cos};
  }
  Vec2f locate(const Vec3f& d) const {
    const double across = maths::atan2(static_cast<double>(d.x), static_cast<double>(-d.z));
    float x = static_cast<float>(across / (2 * kPi)) + 0.5f + turn_;
    x -= std::floor(x);
    return {x, static_cast<float>(maths::acos(static_cast<double>(d.y)) / kPi)};
  }
  /// From the probability of a texel to a density over solid angle.
  float density(float probability, float v) const {
    const float sine = sincos_turns(0.5f * v).sin;
    const float texels = static_cast<float>(width_ * height_);
    return sine > 0 ? probability * texels / (2 * kPif * kPif * sine) : 0;
  }
  void build_tables() {
    double total = 0, rows_total = 0;
    std::vector<double> row_weights;
    for (size_t y = 0; y < height_; ++y) {
      const auto sine = static_cast<double>(
          sincos_turns(0.5f * (static_cast<float>(y) + 0.5f) / static_cast<float>(height_)).sin);
      std::vector<double> weights;
      for (size_t x = 0; x < width_; ++x) {
        // The brightest neighbour too, since lookups between texels reach it.
        double w = 0;
        for (long dy = -1; dy <= 1; ++dy)
          for (long dx = -1; dx <= 1; ++dx)
            w += static_cast<double>(
                luminance(texel(static_cast<long>(x) + dx, static_cast<long>(y) + dy)));
        weights.push_back(w * sine / 9);
      }
      const std::vector<float> table = cumulative(weights, total);
      columns_.insert(columns_.end(), table.begin(), table.end());
      row_weights.push_back(total);
    }
    rows_ = cumulative(row_weights, rows_total);
    importance_ = rows_total > 0 ? kPif : 0;
    // The integral of the sine over all texels is their number times 2 / pi.
    mean_luminance_ =
        static_cast<float>(rows_total * 0.5 * kPi / static_cast<double>(width_ * height_));
  }

  size_t width_ = 0, height_ = 0;
  float turn_, importance_ = 0, mean_luminance_ = 0;
  std::vector<Rgb> texels_;
  std::vector<float> rows_, columns_;
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(sky_image, light, LightPtr, SkyImage, SkyImageLight)
