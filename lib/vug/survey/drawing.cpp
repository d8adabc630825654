// SPDX-License-Identifier: Apache-2.0
#include <vug/base/xml.h>
#include <vug/survey/drawing.h>

#include <vug/survey/extended_elevation.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace vug::survey {
namespace {

/// Lines in metres, the second coordinate upwards.
struct Canvas {
  std::string content;
  Vec2d low{kInfinity}, high{-kInfinity};

  void extend(const Vec2d& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  void line(const Vec2d& a, const Vec2d& b, const char* style) {
    extend(a);
    extend(b);
    content += fmt::format(
        "<line class=\"{}\" x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\"/>\n", style,
        a.x, -a.y, b.x, -b.y);
  }
  /// A dot that shows its name under the mouse pointer.
  void dot(const Vec2d& p, double radius, const char* style, const std::string& name) {
    extend(p);
    content += fmt::format(
        "<circle class=\"{}\" cx=\"{:.2f}\" cy=\"{:.2f}\" "
        "r=\"{:.2f}\"><title>{}</title></circle>\n",
        style, p.x, -p.y, radius, xml_text(name));
  }
  void label(const Vec2d& p, const std::string& text) {
    content +=
        fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\">{}</text>\n", p.x, -p.y, xml_text(text));
  }
};

const char* style_of_leg(const Leg& leg) {
  return leg.splay                      ? "splay"
         : leg.surface                  ? "surface"
         : leg.duplicate                ? "duplicate"
         : leg.style == Style::nosurvey ? "nosurvey"
                                        : "leg";
}

/// The length of the scale bar: 1, 2 or 5 times a power of ten, at most a third of the width.
double bar_length(double width) {
  double length = 1;
  while (length * 10 <= width / 3) length *= 10;
  for (const double factor : {5.0, 2.0})
    if (length * factor <= width / 3) return length * factor;
  return length;
}

/// The radius of the dot of a fixed station.
double dot_radius(const Canvas& canvas) {
  const Vec2d size = canvas.high - canvas.low;
  return 0.005 * std::max({size.x, size.y, 1.0});
}

/// The dot of a station, with the name of an entrance next to it.
void draw_station(Canvas& canvas, const Station& station, const Vec2d& p, double radius) {
  if (station.anonymous()) return;
  const double share = station.entrance ? 1.5 : station.fixed ? 1.0 : 0.4;
  canvas.dot(p, share * radius,
             station.entrance ? "entrance"
             : station.fixed  ? "fixed"
                              : "station",
             station.name);
  if (station.entrance) canvas.label(p + Vec2d(2 * radius, 2 * radius), station.name);
}

/// An arrow to the north in the upper right corner, of a height in metres.
void draw_north(Canvas& canvas, double height) {
  const double x = canvas.high.x, top = -canvas.high.y;
  canvas.content += fmt::format(
      "<path class=\"north\" d=\"M{0:.2f} {1:.2f}V{2:.2f}M{3:.2f} {4:.2f}L{0:.2f} {2:.2f}L{5:.2f} "
      "{4:.2f}\"/>\n<text class=\"north\" x=\"{0:.2f}\" y=\"{6:.2f}\">N</text>\n",
      x, top + height, top, x - 0.2 * height, top + 0.35 * height, x + 0.2 * height,
      top - 0.15 * height);
}

/// The document, with a margin, a title and a scale bar.
std::string document(Canvas& canvas, const Survey& survey, const char* view) {
  if (canvas.content.empty()) canvas.extend({0, 0});
  const Vec2d size = canvas.high - canvas.low;
  const double extent = std::max({size.x, size.y, 1.0}), margin = 0.08 * extent,
               text = 0.025 * extent;
  const double bar = bar_length(std::max(size.x, 1.0) + 2 * margin);
  const double left = canvas.low.x - margin, top = -canvas.high.y - margin;
  const double width = size.x + 2 * margin, height = size.y + 2 * margin;
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{:.2f} {:.2f} {:.2f} {:.2f}\">\n"
      "<title>{}: {}</title>\n<style>line{{stroke:#222;stroke-width:{:.3f};stroke-linecap:round}}"
      ".splay,.width{{stroke:#9ab}}.surface{{stroke:#5a5;stroke-dasharray:{:.3f}}}"
      ".duplicate{{stroke:#999}}.nosurvey,.cut{{stroke-dasharray:{:.3f}}}"
      ".north{{fill:none;stroke:#222;stroke-width:{:.3f}}}text.north{{fill:#222;stroke:none;"
      "text-anchor:middle}}.station{{fill:#222}}.entrance{{fill:#c33}}.fixed{{fill:#36c}}text{{"
      "font:{:.3f}px "
      "sans-serif}}</style>\n",
      left, top, width, height, xml_text(survey.title.empty() ? "Cave survey" : survey.title), view,
      0.002 * extent, 0.01 * extent, 0.005 * extent, 0.002 * extent, text);
  out += canvas.content;
  const double y = top + height - 0.4 * margin, x = left + 0.5 * margin;
  out += fmt::format(
      "<line class=\"scale\" x1=\"{0:.2f}\" y1=\"{1:.2f}\" x2=\"{2:.2f}\" y2=\"{1:.2f}\"/>\n"
      "<text x=\"{0:.2f}\" y=\"{3:.2f}\">{4:g} m</text>\n</svg>\n",
      x, y, x + bar, y - 0.3 * text, bar);
  return out;
}

/// The bearing of the passage at a cross-section as a direction: the mean of its neighbours.
Vec2d direction_at(const Survey& survey, const Tube& tube, size_t i) {
  const auto position = [&](size_t at) {
    const Vec3d& p = survey.stations[static_cast<size_t>(tube[at].station)].position;
    return Vec2d(p.x, p.y);
  };
  const Vec2d along = position(std::min(i + 1, tube.size() - 1)) - position(i == 0 ? 0 : i - 1);
  return along.length() > 0 ? along.normalized() : Vec2d(0, 1);
}

void draw_widths(Canvas& canvas, const Survey& survey) {
  for (const Tube& tube : survey.tubes)
    for (size_t i = 0; i < tube.size(); ++i) {
      const Vec2d along = direction_at(survey, tube, i), right(along.y, -along.x);
      const Vec3d& p = survey.stations[static_cast<size_t>(tube[i].station)].position;
      const Vec2d center(p.x, p.y);
      canvas.line(center - right * tube[i].left.value_or(0),
                  center + right * tube[i].right.value_or(0), "width");
    }
}

}  // namespace

std::string plan_svg(const Survey& survey) {
  Canvas canvas;
  draw_widths(canvas, survey);
  const auto place = [&](int station) {
    const Vec3d& p = survey.stations[static_cast<size_t>(station)].position;
    return Vec2d(p.x, p.y);
  };
  for (const Leg& leg : survey.legs) canvas.line(place(leg.from), place(leg.to), style_of_leg(leg));
  const double radius = dot_radius(canvas);
  for (size_t i = 0; i < survey.stations.size(); ++i)
    draw_station(canvas, survey.stations[i], place(static_cast<int>(i)), radius);
  if (!survey.stations.empty()) draw_north(canvas, 12 * radius);
  return document(canvas, survey, "plan");
}

std::string elevation_svg(const Survey& survey) {
  Canvas canvas;
  const std::vector<ElevationLeg> legs = extend_elevation(survey);
  for (const ElevationLeg& each : legs) {
    const Leg& leg = survey.legs[static_cast<size_t>(each.leg)];
    canvas.line(each.ends[0], each.ends[1], each.cut ? "cut" : style_of_leg(leg));
  }
  const double radius = dot_radius(canvas);
  std::set<std::pair<int, double>> drawn;  // A station at a cut is at several places.
  for (const ElevationLeg& each : legs)
    for (size_t end = 0; end < 2; ++end)
      if (drawn.emplace(each.stations[end], each.ends[end].x).second)
        draw_station(canvas, survey.stations[static_cast<size_t>(each.stations[end])],
                     each.ends[end], radius);
  return document(canvas, survey, "extended elevation");
}

}  // namespace vug::survey
