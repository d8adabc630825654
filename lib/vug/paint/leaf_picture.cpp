// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/paint/leaf_pattern.h>
#include <vug/paint/leaf_picture.h>

#include <algorithm>

namespace vug::paint {
namespace {

/// Leaf coordinates of a point, as the attributes of a leaf mesh.
class LeafAttributes : public Attributes {
 public:
  explicit LeafAttributes(const LeafPoint& place) : place_(place) {}
  std::optional<Vec3d> read(std::string_view name) const override {
    if (name == kLeafAcross) return Vec3d(place_.across);
    if (name == kLeafAlong) return Vec3d(place_.along);
    return std::nullopt;
  }

 private:
  LeafPoint place_;
};

}  // namespace

image::Image leaf_picture(const Paint& color, const Mask& opacity,
                          const LeafPictureOptions& options) {
  const int n = options.samples;
  if (!color || n < 1)
    throw Error(ErrorCode::bad_input, "a leaf picture needs a paint and at least 1 sample");
  image::Image picture(options.width, options.height, {"R", "G", "B", "A"});
  parallel_for(static_cast<size_t>(options.height), [&](size_t row) {
    for (int column = 0; column < options.width; ++column) {
      Vec3d sum(0);
      double cover = 0;
      for (int k = 0; k < n * n; ++k) {
        const int across = k % n, down = k / n;
        const double x = (column + (across + 0.5) / n) / options.width;
        const double y = (static_cast<double>(row) + (down + 0.5) / n) / options.height;
        const LeafAttributes place({2 * x - 1, 1 - y});
        // Other inputs than leaf coordinates see a flat leaf of unit length on the ground.
        EvalPoint point{Vec3d(2 * x - 1, 1 - y, 0), Vec3d(0, 0, 1)};
        point.attributes = &place;
        sum += (*color)(point);
        cover += opacity ? std::clamp((*opacity)(point), 0.0, 1.0) : 1;
      }
      for (size_t c = 0; c < 3; ++c)
        picture.at(column, static_cast<int>(row), c) =
            static_cast<float>(std::clamp(sum[static_cast<int>(c)] / (n * n), 0.0, 1.0));
      picture.at(column, static_cast<int>(row), 3) = static_cast<float>(cover / (n * n));
    }
  });
  return picture;
}

}  // namespace vug::paint
