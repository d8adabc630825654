// SPDX-License-Identifier: Apache-2.0
// The edges of a polygon, and the selection of the few that matter near some points.
#pragma once

#include <vug/base/digester.h>
#include <vug/base/vec.h>
#include <vug/field/numbers/pack.h>

#include <bit>
#include <cstdint>
#include <vector>

namespace vug::passages {

using field::Pack;

struct Edge {
  Edge(const Vec2d& from, const Vec2d& to) : a(from), b(to), along(to - from) {
    const double length = along.length();
    inverse = 1 / (length * length);
    normal = Vec2d(along.y, -along.x) / length;  // Outwards, for a counterclockwise outline.
  }
  Vec2d a, b, along, normal;
  double inverse;

  void add_to(Digester& digester) const { digester(a, b); }
};

/// A rectangle of points in the plane of a section, by its centre and half its size.
struct PlaneRectangle {
  Vec2d centre{0, 0}, half{0, 0};
};
/// Around `count` points or packs of points, at least one.
PlaneRectangle rectangle_around(const Pack* u, const Pack* v, int count);
PlaneRectangle rectangle_around(const double* u, const double* v, int count);

/// Selects edges in single precision, eight at a time. The bounds are wider than the rounding of
/// the selection and of the distances of packs, so that the nearest of the selected edges is the
/// nearest of all edges, bit for bit.
class EdgeLanes {
 public:
  /// Empty, where a selection would not pay: for few edges, and for more than kMost.
  explicit EdgeLanes(const std::vector<Edge>& edges);
  bool empty() const { return lanes_.empty(); }

  class Selection {
   public:
    /// Calls near(i) for the edges that can be the nearest one of a point, in order, then
    /// crossed(i) for the others whose height along v some point can have.
    template <class Near, class Crossed>
    void visit(const Near& near, const Crossed& crossed) const {
      visit(near_, near);
      visit(crossed_, crossed);
    }

   private:
    friend class EdgeLanes;
    template <class Visit>
    void visit(const uint8_t* bits, const Visit& each) const {
      for (size_t k = 0; k < packs_; ++k)
        for (unsigned left = bits[k]; left != 0; left &= left - 1)
          each(Pack::kLanes * k + static_cast<size_t>(std::countr_zero(left)));
    }
    size_t packs_ = 0;
    uint8_t near_[32], crossed_[32];
  };
  Selection select(const PlaneRectangle& points) const;

  static constexpr size_t kMost = Pack::kLanes * sizeof(Selection::near_);

 private:
  static constexpr size_t kFewest = 12;
  struct Lanes {
    float a[2][Pack::kLanes], along[2][Pack::kLanes], inverse[Pack::kLanes];
    float low[Pack::kLanes], high[Pack::kLanes];  // Along v.
  };
  std::vector<Lanes> lanes_;
  double size_ = 0;  // The largest distance of a corner from the origin.
};

}  // namespace vug::passages
