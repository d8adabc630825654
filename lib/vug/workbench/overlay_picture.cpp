// SPDX-License-Identifier: Apache-2.0
// The picture that `export png` writes.
#include <vug/fit/evidence/working_size.h>
#include <vug/image/io.h>
#include <vug/workbench/export_facade.h>
#include <vug/workbench/facade_bench.h>

#include <algorithm>
#include <cmath>

namespace vug::workbench {
namespace {

constexpr ElementColour kOpen = {1, 0.28f, 0};  // of areas that no rule divides yet

/// A wall of 100 pixels a metre, at most 2000 wide, for sessions without a photo.
image::Image plain_wall(const modeller::Canvas& canvas) {
  const double pixels = std::min(100.0, 2000 / std::max(canvas.width, canvas.height));
  const auto size = [&](double metres) { return std::max(1, static_cast<int>(metres * pixels)); };
  image::Image out(size(canvas.width), size(canvas.height), {"R", "G", "B"});
  std::fill(out.pixels.begin(), out.pixels.end(), 0.6f);
  return out;
}

class OverlayPainter {
 public:
  OverlayPainter(image::Image& picture, const modeller::Canvas& canvas)
      : picture_(picture),
        x_(picture.width / canvas.width),
        y_(picture.height / canvas.height),
        line_(std::max(1, picture.width / 400)) {}

  void rect(const facade::Rect& r, const ElementColour& colour, float fill) {
    const int x0 = column(r.x), x1 = column(r.right()), y0 = row(r.top()), y1 = row(r.y);
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x) {
        const bool edge = x < x0 + line_ || x >= x1 - line_ || y < y0 + line_ || y >= y1 - line_;
        blend(x, y, colour, edge ? 1 : fill);
      }
  }

 private:
  int column(double metres) const {
    return std::clamp(static_cast<int>(std::lround(metres * x_)), 0, picture_.width);
  }
  int row(double metres) const {
    return std::clamp(picture_.height - static_cast<int>(std::lround(metres * y_)), 0,
                      picture_.height);
  }
  void blend(int x, int y, const ElementColour& colour, float share) {
    float* pixel = &picture_.at(x, y);
    const float to[] = {colour.r, colour.g, colour.b};
    for (int c = 0; c < 3; ++c) pixel[c] += share * (to[c] - pixel[c]);
  }

  image::Image& picture_;
  double x_, y_;
  int line_;
};

}  // namespace

ElementColour element_colour(const std::string& kind) {
  if (kind == "window") return {0.03f, 0.28f, 0.85f};
  if (kind == "door" || kind == "doorway") return {0.75f, 0.1f, 0.05f};
  if (kind == "shop") return {0.5f, 0.07f, 0.6f};
  return {0.02f, 0.45f, 0.25f};
}

image::Image overlay_picture(const FacadeBench& bench) {
  const modeller::FacadeState& state = bench.document().state();
  image::Image out =
      bench.photo().empty() ? plain_wall(state.canvas()) : fit::read_photo(bench.photo());
  OverlayPainter painter(out, state.canvas());
  for (const Shape& each : shapes(state)) {
    if (each.kind == Shape::Kind::element)
      painter.rect(each.rect, element_colour(each.symbol), 0.25f);
    if (each.kind == Shape::Kind::open) painter.rect(each.rect, kOpen, 0.2f);
  }
  return out;
}

}  // namespace vug::workbench
