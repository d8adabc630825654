// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/facade/blocks.h>
#include <vug/facade/outline.h>
#include <vug/field/affine.h>
#include <vug/field/boolean.h>
#include <vug/field/registry.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::facade {
namespace {

/// A round bar along z.
field::Field bar(const Vec2d& centre, double radius, double back, double front) {
  const field::Field upright =
      field::make("cylinder", {{"radius", radius}, {"height", front - back}});
  return field::transformed(upright,
                            Transform::translation({centre.x, centre.y, 0.5 * (back + front)}) *
                                Transform({1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {0, 0, 0}));
}

}  // namespace

void Solids::take(Solids more) {
  const auto move = [](std::vector<field::Field>& from, std::vector<field::Field>& to) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  };
  move(more.cut, cut);
  move(more.add, add);
  move(more.fill, fill);
}

field::Field block(const Rect& rect, double back, double front, double rounding) {
  if (!(rect.width > 0 && rect.height > 0 && front > back))
    throw Error(ErrorCode::bad_input,
                fmt::format("invalid size of a block: {:.4g} x {:.4g} x {:.4g} m", rect.width,
                            rect.height, front - back));
  const Vec3d size(rect.width, rect.height, front - back);
  const double most = 0.49 * std::min({size.x, size.y, size.z});
  const field::Field box =
      field::make("box", {{"size", size}, {"rounding", std::min(rounding, most)}});
  return field::transformed(
      box, Transform::translation(
               {rect.x + 0.5 * rect.width, rect.y + 0.5 * rect.height, 0.5 * (back + front)}));
}

double rise_of(Head head, double rise, double width, double height) {
  if (head == Head::flat) return 0;
  const double own = head == Head::segmental ? width / 6
                     : head == Head::round   ? width / 2
                                             : std::sqrt(0.75) * width;
  return std::min(rise > 0 ? rise : own, 0.999 * height);
}

field::Field arched_block(const Rect& rect, Head head, double rise, double back, double front) {
  const double up = rise_of(head, rise, rect.width, rect.height);
  if (!(up > 0)) return block(rect, back, front);
  const double half = rect.width / 2, spring = rect.top() - up, middle = rect.x + half;
  const field::Field below = block({rect.x, rect.y, rect.width, spring - rect.y}, back, front);
  if (head == Head::pointed) {
    const double radius = (half * half + up * up) / rect.width;
    return field::unite(
        {below, field::intersect({bar({rect.x + radius, spring}, radius, back, front),
                                  bar({rect.right() - radius, spring}, radius, back, front),
                                  block(rect, back, front)})});
  }
  const double radius = (half * half + up * up) / (2 * up);
  return field::unite(
      {below, field::intersect({bar({middle, rect.top() - radius}, radius, back, front),
                                block(rect, back, front)})});
}

std::string Opening::opening_fault() const {
  if (frame > 0 && !(frame_depth > 0)) return "the depth of a frame must be above 0";
  if (sill > 0 && !(sill_height > 0)) return "the height of a sill must be above 0";
  if (lintel > 0 && !(lintel_height > 0)) return "the height of a lintel must be above 0";
  return "";
}

field::Field Opening::sheet(double width, double height, double back, double front) const {
  return arched_block({0, 0, width, height}, head, rise, -back, -front);
}

Solids Opening::around(double width, double height, double depth) const {
  Solids out;
  const Rect hole{0, 0, width, height};
  const double out_most = std::max({frame > 0 ? frame_depth : 0, kCutMargin});
  out.cut.push_back(arched_block(hole, head, rise, -depth, out_most));
  if (frame > 0) {
    // The moulding has one step towards the opening.
    const auto ring = [&](double outer, double inner, double front) {
      const auto grown = [&](double by, double from, double to) {
        return arched_block({-by, 0, width + 2 * by, height + by}, head, rise > 0 ? rise + by : 0,
                            from, to);
      };
      return field::subtract(grown(outer, -0.02, front), {grown(inner, -1, 1)});
    };
    out.add.push_back(ring(frame, 0.4 * frame, frame_depth));
    out.add.push_back(ring(0.45 * frame, 0, 0.6 * frame_depth));
  }
  if (sill > 0) {
    const double past = std::max(0.05, frame);
    out.add.push_back(moulding({{-depth, -sill_height},
                                {0.75 * sill, -sill_height},
                                {sill, -0.7 * sill_height},
                                {sill, -0.15 * sill_height},
                                {-depth, 0.02}},
                               -past, width + past));
  }
  const double top = height + frame;
  if (lintel > 0) {
    const double past = std::max(0.08, frame);
    out.add.push_back(moulding({{-0.05, top},
                                {0.35 * lintel, top},
                                {0.35 * lintel, top + 0.5 * lintel_height},
                                {0.85 * lintel, top + 0.7 * lintel_height},
                                {lintel, top + 0.78 * lintel_height},
                                {lintel, top + 0.92 * lintel_height},
                                {-0.05, top + lintel_height}},
                               -past, width + past));
  }
  if (keystone > 0) {
    const double half = std::min(0.12 * width, 0.2), tall = std::max(frame, 0.25) + 0.04;
    const double middle = width / 2, low = height - 0.06;
    out.add.push_back(extruded({{middle - 0.75 * half, low},
                                {middle + 0.75 * half, low},
                                {middle + half, low + tall},
                                {middle - half, low + tall}},
                               -0.05, keystone));
  }
  return out;
}

}  // namespace vug::facade
