// SPDX-License-Identifier: Apache-2.0
// Maximal Poisson-disk sampling (cite ebeida2012): dart throwing with a minimum distance until the
// requested number is reached or no room is left. Squares that may still be free are quartered
// until a disk covers each of them.
#include <vug/flora/distribution.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::flora {
namespace {

constexpr double kMaxSquares = 1 << 26;
constexpr int kDeepest = 48;  // Squares of the size of rounding errors.
constexpr int32_t kNobody = -1;

struct PoissonDisk {
  double distance = 1;

  static void describe(Schema<PoissonDisk>& s) {
    s.doc("A minimum distance between any two plants. Without a density: as many as fit.")
        .cite("ebeida2012")
        .param("distance", &PoissonDisk::distance,
               positive_length("minimum between any two plants"));
  }
};

/// Squares so small that each contains at most one point.
class DartThrower {
 public:
  DartThrower(const Plot& plot, double distance) : plot_(plot), distance_(distance) {
    side_ = size_ = distance / std::sqrt(2.0);
    const Vec2d size = (plot.high() - plot.low()) / side_;
    if (!((size.x + 1) * (size.y + 1) <= kMaxSquares))
      throw Error(
          ErrorCode::too_large,
          fmt::format("the box around a plot of {:.4g} m^2 has room for {:.2g} plants {:.3g} m "
                      "apart; the limit is {:.2g}",
                      plot.area(), size.x * size.y, distance, kMaxSquares),
          {}, "use a larger distance, or several shorter plots");
    columns_ = static_cast<int64_t>(size.x) + 1, rows_ = static_cast<int64_t>(size.y) + 1;
    in_square_.assign(static_cast<size_t>(columns_ * rows_), kNobody);
    for (int64_t row = 0; row < rows_; ++row)
      for (int64_t column = 0; column < columns_; ++column)
        keep({corner(column, row), row * columns_ + column}, side_);
    open_.swap(next_);
  }

  bool full() const { return open_.empty(); }
  size_t open() const { return open_.size(); }
  const std::vector<Vec2d>& points() const { return points_; }

  void throw_one(RandomStream& random) {
    const Square& square = open_[random.below(static_cast<uint32_t>(open_.size()))];
    const double x = random.uniform(), y = random.uniform();
    const Vec2d p = square.low + Vec2d(x, y) * size_;
    if (in_square_[static_cast<size_t>(square.base)] != kNobody || !plot_.contains(p)) return;
    const auto too_near = [&](const Vec2d& other) {
      return (other - p).length2() < distance_ * distance_;
    };
    if (any_about(square.base, too_near)) return;
    in_square_[static_cast<size_t>(square.base)] = static_cast<int32_t>(points_.size());
    points_.push_back(p);
  }

  /// Quarters the open squares and keeps those that may take another point.
  void divide() {
    next_.clear();
    size_ /= 2;
    for (const Square& square : open_)
      for (int quarter = 0; quarter < 4; ++quarter)
        keep({square.low + Vec2d(quarter & 1, quarter >> 1) * size_, square.base}, size_);
    open_.swap(next_);
    if (++depth_ > kDeepest) open_.clear();
  }

 private:
  struct Square {
    Vec2d low;
    int64_t base;
  };
  Vec2d corner(int64_t column, int64_t row) const {
    return plot_.low() + Vec2d(static_cast<double>(column), static_cast<double>(row)) * side_;
  }

  void keep(const Square& square, double size) {
    if (in_square_[static_cast<size_t>(square.base)] != kNobody) return;
    const Vec2d middle = square.low + Vec2d(size / 2);
    const auto covers = [&](const Vec2d& p) {
      const Vec2d far(std::fabs(p.x - middle.x) + size / 2, std::fabs(p.y - middle.y) + size / 2);
      return far.length2() < distance_ * distance_;
    };
    if (any_about(square.base, covers)) return;
    if (!plot_.contains(middle) && plot_.border_distance(middle) > size / std::sqrt(2.0)) return;
    next_.push_back(square);
  }

  /// Whether `is` holds for any point that may be within the distance of the square.
  template <class Test>
  bool any_about(int64_t base, const Test& is) const {
    const int64_t column = base % columns_, row = base / columns_;
    for (int64_t y = std::max<int64_t>(row - 2, 0); y <= std::min(row + 2, rows_ - 1); ++y)
      for (int64_t x = std::max<int64_t>(column - 2, 0); x <= std::min(column + 2, columns_ - 1);
           ++x) {
        const int32_t point = in_square_[static_cast<size_t>(y * columns_ + x)];
        if (point != kNobody && is(points_[static_cast<size_t>(point)])) return true;
      }
    return false;
  }

  const Plot& plot_;
  double distance_;
  double side_ = 0, size_ = 0;  ///< Side lengths of the first squares and of the open squares.
  int depth_ = 0;
  int64_t columns_ = 0, rows_ = 0;
  std::vector<int32_t> in_square_;
  std::vector<Square> open_, next_;
  std::vector<Vec2d> points_;
};

class DiskPoints final : public Distribution {
 public:
  explicit DiskPoints(const PoissonDisk& p) : p_(p) {}

  bool fills() const override { return true; }
  std::vector<Vec2d> points(const Plot& plot, double density, RandomKey key,
                            Progress& progress) const override {
    if (density != 0) require_density(density, plot.area());
    const double wanted = density == 0 ? kInfinity : std::round(density * plot.area());
    RandomStream random(key);
    DartThrower darts(plot, p_.distance);
    const auto enough = [&] { return static_cast<double>(darts.points().size()) >= wanted; };
    for (; !darts.full() && !enough(); darts.divide()) {
      progress.check();
      const size_t count = darts.open();
      for (size_t i = 0; i < count && !enough(); ++i) darts.throw_one(random);
    }
    if (!enough() && density != 0)
      throw Error(ErrorCode::bad_input,
                  fmt::format("{:.0f} plants {:.3g} m apart do not fit: the plot only takes {}",
                              wanted, p_.distance, darts.points().size()),
                  {}, "lower the density or the distance, or omit the density for as many as fit");
    return darts.points();
  }

 private:
  PoissonDisk p_;
};

}  // namespace
}  // namespace vug::flora

VUG_DISTRIBUTION_KIND(poisson_disk) {
  return distribution_kind<PoissonDisk, DiskPoints>("poisson_disk");
}
