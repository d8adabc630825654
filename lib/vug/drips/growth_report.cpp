// SPDX-License-Identifier: Apache-2.0
#include <vug/drips/growth.h>
#include <vug/drips/growth_report.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::drips {
namespace {

using Shape = GrowthCheck::Shape;

double distance(const Vec2d& p, const Vec2d& a, const Vec2d& b) {
  const Vec2d way = b - a;
  const double square = way.x * way.x + way.y * way.y;
  const Vec2d to = p - a;
  const double t = square > 0 ? std::clamp((to.x * way.x + to.y * way.y) / square, 0.0, 1.0) : 0.0;
  return (to - way * t).length();
}

/// The greatest distance of the corners of an outline from another one.
double greatest_distance(const std::vector<Vec2d>& corners, const std::vector<Vec2d>& outline) {
  double most = 0;
  for (const Vec2d& p : corners) {
    double least = kInfinity;
    for (size_t i = 1; i < outline.size(); ++i)
      least = std::min(least, distance(p, outline[i - 1], outline[i]));
    if (outline.size() > 1) most = std::max(most, least);
  }
  return most;
}

/// The Hausdorff distance of both outlines and the shift: a bound of the step of the surface.
double step_between(const Shape& a, const Shape& b) {
  return std::max(greatest_distance(a.outline, b.outline),
                  greatest_distance(b.outline, a.outline)) +
         (a.shift - b.shift).length();
}

Shape shape_of(const Form& form, const FormOptions& o, const field::StalactiteCurve& curve) {
  Shape out{kind_name(form.kind), form.drip, outline_of(form, o, curve), {}, 0, 0, false};
  const double length = (form.top - form.bottom).length();
  const bool stands = form.kind == FormKind::stalagmite || form.kind == FormKind::column;
  // Heights of hanging forms are counted from the roof, where the outline is cut.
  const double from = stands ? 0 : length;
  for (Vec2d& p : out.outline) p.y = std::clamp(p.y, stands ? 0.0 : -form.radius, length) - from;
  const Vec3d axis = form.top - form.bottom;
  out.shift = Vec3d(axis.x, 0, axis.z);
  out.size = form.kind == FormKind::column ? form.cover * (form.radius + form.coat) : length;
  out.broken = form.broken * length;
  out.fallen = form.kind == FormKind::piece;
  return out;
}

Shape shape_of(const HungDrapery& drapery) {
  const field::Drapery& sheet = drapery.sheet;
  return {"drapery",
          drapery.drip,
          {{0.5 * sheet.root_thickness, 0}, {0.5 * sheet.edge, -sheet.width}},
          sheet.path.front(),
          sheet.width,
          0,
          false};
}

/// The thickness over the distance from the middle: its change is the step of the surface.
Shape shape_of(const field::Deposit& layer) {
  constexpr double kStep = 0.03;
  constexpr int kSteps = 30;
  const double t = std::max(layer.thickness_from, layer.thickness_to);
  const double w = std::max(layer.half_width_from, layer.half_width_to);
  Shape out{"flowstone", layer.drip, {}, {}, t, 0, false};
  for (int i = 0; i <= kSteps; ++i) {
    const double share = std::max(0.0, 1 - (i * kStep / w) * (i * kStep / w));
    out.outline.emplace_back(i * kStep, t * share * share);
  }
  return out;
}

GrowthCheck::Shapes shapes_of(const Dripstone& grown, const FormOptions& forms) {
  const field::StalactiteCurve curve = common_curve(forms.girth);
  GrowthCheck::Shapes out;
  for (const Form& form : grown.forms)
    out.emplace(fmt::format("{} {}", kind_name(form.kind), form.drip),
                shape_of(form, forms, curve));
  for (const HungDrapery& drapery : grown.draperies)
    out.emplace(fmt::format("drapery {}", drapery.drip), shape_of(drapery));
  for (const field::Deposit& layer : grown.layers)
    out.emplace(
        fmt::format("layer {} {} {} {}", layer.drip, layer.from.x, layer.from.y, layer.from.z),
        shape_of(layer));
  return out;
}

GrowthEvent event(int frame, const Shape& shape, double size) {
  return {frame, shape.kind, shape.drip, size};
}

void keep_greater(const GrowthEvent& event, GrowthEvent& greatest) {
  if (event.size > greatest.size) greatest = event;
}

}  // namespace

void GrowthCheck::add(int frame, const Dripstone& grown, const FormOptions& forms) {
  Shapes now = shapes_of(grown, forms);
  for (const auto& [name, shape] : now) {
    const auto before = before_.find(name);
    if (before == before_.end()) {
      if (!shape.fallen) keep_greater(event(frame, shape, shape.size), report_.first);
    } else if (shape.broken > 0 && before->second.broken == 0) {
      report_.broken.push_back(event(frame, shape, shape.broken));
    } else {
      keep_greater(event(frame, shape, step_between(before->second, shape)), report_.step);
    }
  }
  for (const auto& [name, shape] : before_)
    if (!now.contains(name)) report_.lost.push_back(event(frame, shape, shape.size));
  ++report_.frames;
  report_.speleothems = now.size();
  before_ = std::move(now);
}

}  // namespace vug::drips
