#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/fit/features.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace vug::fit {
namespace {

using Plane = std::vector<float>;

/// Works on planes of one size.
class Picture {
 public:
  Picture(int width, int height)
      : width_(width), height_(height), unit_(std::max(1, height / 160)) {}

  int unit() const { return unit_; }
  size_t pixels() const { return static_cast<size_t>(width_) * static_cast<size_t>(height_); }
  size_t index(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x);
  }

  template <class Value>
  Plane make(const Value& value) const {
    Plane out(pixels());
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) out[index(x, y)] = static_cast<float>(value(x, y));
    return out;
  }

  /// Means over boxes of a plane: over the part of each box that is in the picture.
  class Means {
   public:
    Means(const Picture& picture, const Plane& plane)
        : picture_(picture),
          table_((static_cast<size_t>(picture.width_) + 1) *
                     (static_cast<size_t>(picture.height_) + 1),
                 0) {
      for (int y = 0; y < picture_.height_; ++y) {
        double row = 0;
        for (int x = 0; x < picture_.width_; ++x) {
          row += plane[picture_.index(x, y)];
          at(x + 1, y + 1) = at(x + 1, y) + row;
        }
      }
    }
    Plane box(int half_x, int half_y) const {
      return picture_.make([&](int x, int y) {
        const int x0 = std::max(0, x - half_x), x1 = std::min(picture_.width_, x + half_x + 1);
        const int y0 = std::max(0, y - half_y), y1 = std::min(picture_.height_, y + half_y + 1);
        return (at(x1, y1) - at(x0, y1) - at(x1, y0) + at(x0, y0)) /
               (static_cast<double>(x1 - x0) * (y1 - y0));
      });
    }
    Plane box(int half) const { return box(half, half); }
    Plane rows() const { return box(picture_.width_, picture_.unit_); }
    Plane columns() const { return box(picture_.unit_, picture_.height_); }
    Plane whole() const { return box(picture_.width_, picture_.height_); }

   private:
    size_t place(int x, int y) const {
      return static_cast<size_t>(y) * (static_cast<size_t>(picture_.width_) + 1) +
             static_cast<size_t>(x);
    }
    double& at(int x, int y) { return table_[place(x, y)]; }
    double at(int x, int y) const { return table_[place(x, y)]; }

    const Picture& picture_;
    std::vector<double> table_;
  };
  Means means(const Plane& plane) const { return Means(*this, plane); }

  Plane squared(const Plane& plane) const {
    Plane out(plane);
    for (float& v : out) v *= v;
    return out;
  }
  /// Of values whose means and whose squares' means are given.
  Plane deviation(const Plane& mean, const Plane& mean_square) const {
    Plane out(mean_square);
    for (size_t i = 0; i < out.size(); ++i)
      out[i] = std::sqrt(std::max(0.0f, out[i] - mean[i] * mean[i]));
    return out;
  }

  Plane edges(const Plane& plane, bool along_x) const {
    return make([&](int x, int y) {
      const int x0 = along_x ? std::max(0, x - 1) : x, y0 = along_x ? y : std::max(0, y - 1);
      const int x1 = along_x ? std::min(width_ - 1, x + 1) : x;
      const int y1 = along_x ? y : std::min(height_ - 1, y + 1);
      return std::fabs(plane[index(x1, y1)] - plane[index(x0, y0)]);
    });
  }

  Plane shifted(const Plane& plane, int dx, int dy) const {
    return make([&](int x, int y) {
      return plane[index(std::clamp(x + dx, 0, width_ - 1), std::clamp(y + dy, 0, height_ - 1))];
    });
  }

  Plane difference(const Plane& a, const Plane& b) const {
    Plane out(a);
    for (size_t i = 0; i < out.size(); ++i) out[i] -= b[i];
    return out;
  }

  /// Of a plane that is blurred already: what is to the left and right, above and below.
  void add_surroundings(const Plane& plane, int distance, std::vector<Plane>& out) const {
    for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}})
      out.push_back(shifted(plane, dx * distance, dy * distance));
  }

 private:
  int width_, height_, unit_;
};

/// f of the definition of L*a*b*.
double cube_root(double t) {
  constexpr double kDelta = 6.0 / 29;
  return t > kDelta * kDelta * kDelta ? maths::pow(t, 1.0 / 3)
                                      : t / (3 * kDelta * kDelta) + 4.0 / 29;
}

}  // namespace

Planes to_lab(const image::Image& linear) {
  const image::Image rgb = linear.select({"R", "G", "B"});
  Planes out{rgb.width, rgb.height, std::vector<Plane>(3, Plane(rgb.pixel_count()))};
  parallel_for(
      rgb.pixel_count(),
      [&](size_t i) {
        const double r = rgb.pixels[3 * i], g = rgb.pixels[3 * i + 1], b = rgb.pixels[3 * i + 2];
        // IEC 61966-2-1; white is (0.9505, 1, 1.089).
        const double x = cube_root((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505);
        const double y = cube_root(0.2126 * r + 0.7152 * g + 0.0722 * b);
        const double z = cube_root((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089);
        out.planes[0][i] = static_cast<float>(116 * y - 16);
        out.planes[1][i] = static_cast<float>(500 * (x - y));
        out.planes[2][i] = static_cast<float>(200 * (y - z));
      },
      1024);
  return out;
}

Planes flattened(const Planes& planes) {
  const Picture picture(planes.width, planes.height);
  Planes out = planes;
  for (Plane& plane : out.planes)
    plane = picture.difference(plane, picture.means(plane).box(std::max(1, planes.height / 10)));
  return out;
}

Planes features(const image::Image& linear) {
  Planes out = to_lab(linear);
  const Picture picture(out.width, out.height);
  const int unit = picture.unit();
  const std::vector<Plane> lab = out.planes;
  std::vector<Plane>& all = out.planes;
  const Plane& lightness = lab[0];
  const Picture::Means light = picture.means(lightness);
  for (const Plane& plane : lab) {
    const Picture::Means means = picture.means(plane);
    const Plane near = means.box(3 * unit), whole = means.whole(), rows = means.rows();
    all.push_back(means.box(unit));
    all.push_back(near);
    all.push_back(means.box(8 * unit));
    all.push_back(whole);
    all.push_back(picture.difference(rows, whole));
    all.push_back(picture.difference(means.columns(), whole));
    all.push_back(picture.difference(near, rows));
  }
  const Picture::Means squares = picture.means(picture.squared(lightness));
  for (const int half : {unit, 3 * unit, 8 * unit})
    all.push_back(picture.deviation(light.box(half), squares.box(half)));
  for (const bool along_x : {true, false}) {
    const Picture::Means edges = picture.means(picture.edges(lightness, along_x));
    all.push_back(edges.box(unit));
    all.push_back(edges.box(4 * unit));
    all.push_back(edges.rows());
    all.push_back(edges.columns());
  }
  const Plane soft = light.box(2 * unit);
  for (const int distance : {6 * unit, 14 * unit}) picture.add_surroundings(soft, distance, all);
  all.push_back(picture.make([&](int x, int) { return std::fabs((x + 0.5) / out.width - 0.5); }));
  all.push_back(picture.make([&](int, int y) { return (y + 0.5) / out.height; }));
  return out;
}

Planes context_features(const Planes& maps) {
  const Picture picture(maps.width, maps.height);
  const int unit = picture.unit();
  Planes out{maps.width, maps.height, {}};
  for (const Plane& map : maps.planes) {
    std::vector<Plane>& all = out.planes;
    const Picture::Means means = picture.means(map);
    const Plane soft = means.box(2 * unit);
    all.push_back(map);
    all.push_back(soft);
    all.push_back(means.box(8 * unit));
    all.push_back(means.rows());
    all.push_back(means.columns());
    all.push_back(means.box(out.width, 8 * unit));
    all.push_back(means.box(1, 12 * unit));
    all.push_back(means.box(12 * unit, 1));
    picture.add_surroundings(soft, 8 * unit, all);
    picture.add_surroundings(soft, 20 * unit, all);
  }
  return out;
}

}  // namespace vug::fit
