// SPDX-License-Identifier: Apache-2.0
#include "overlay_painter.h"

#include "bench_studio.h"
#include "theme.h"

#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <vector>

namespace vug::studio {
namespace {

using language::HandleRole;
using workbench::OverlayGizmo;
using workbench::OverlayHandle;

/// The axes x, y and z in red, green and blue, as in most 3D programs.
const QColor kAxisColours[] = {QColor("#ff5b5b"), QColor("#5fd35f"), QColor("#5f9bff")};
const QColor kHandleColour("#ffd84d"), kGizmoColour("#ffe9b0"), kDark(0, 0, 0, 170);
constexpr double kStroke = 2, kKnob = 5, kBulb = 7, kArrowHead = 8;

/// Lines and symbols have a dark rim, so that they are visible on any picture.
void draw_path(QPainter& painter, const QPainterPath& path, const QColor& colour, bool filled) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(kDark, kStroke + 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(path);
  painter.setPen(QPen(colour, kStroke, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  if (filled) painter.setBrush(colour);
  painter.drawPath(path);
}

QPainterPath line_path(const QPointF& from, const QPointF& to) {
  QPainterPath path(from);
  path.lineTo(to);
  return path;
}

QPainterPath circle_path(const QPointF& center, double radius) {
  QPainterPath path;
  path.addEllipse(center, radius, radius);
  return path;
}

QPainterPath arrow_head(const QPointF& from, const QPointF& to) {
  const QPointF along = to - from;
  const double length = std::hypot(along.x(), along.y());
  if (length < 1) return circle_path(to, 2);
  const QPointF unit = along / length, side(-unit.y(), unit.x());
  QPainterPath path(to);
  path.lineTo(to - unit * kArrowHead + side * kArrowHead / 2);
  path.lineTo(to - unit * kArrowHead - side * kArrowHead / 2);
  path.closeSubpath();
  return path;
}

class OverlayPainter {
 public:
  OverlayPainter(QPainter& painter, double ratio) : painter_(painter), ratio_(ratio) {}

  void draw(const OverlayGizmo& gizmo) {
    const QPointF at = point(gizmo.at);
    const QColor colour = gizmo.selected ? kHandleColour : kGizmoColour;
    if (gizmo.tip) {
      draw_path(painter_, line_path(at, point(*gizmo.tip)), colour, false);
      draw_path(painter_, arrow_head(at, point(*gizmo.tip)), colour, true);
    }
    if (gizmo.kind == "camera") {
      QPainterPath body;
      body.addRoundedRect(QRectF(at.x() - 8, at.y() - 5, 12, 10), 2, 2);
      body.moveTo(at + QPointF(4, -1));
      body.lineTo(at + QPointF(9, -4));
      body.lineTo(at + QPointF(9, 4));
      body.lineTo(at + QPointF(4, 1));
      return draw_path(painter_, body, colour, gizmo.selected);
    }
    draw_path(painter_, circle_path(at, kBulb), colour, gizmo.selected);
    for (int i = 0; !gizmo.tip && i < 8; ++i) {
      const QPointF ray(std::cos(i * kPi / 4), std::sin(i * kPi / 4));
      draw_path(painter_, line_path(at + ray * (kBulb + 3), at + ray * (kBulb + 6)), colour, false);
    }
  }

  void draw(const OverlayHandle& handle, bool hovered) {
    const QPointF at = point(handle.at);
    const QColor colour = hovered ? QColor(Qt::white) : kHandleColour;
    for (size_t i = 0; i < 3; ++i) {
      if (!handle.axes[i]) continue;
      const QPointF end = point(*handle.axes[i]);
      draw_path(painter_, line_path(at, end), kAxisColours[i], false);
      draw_path(painter_, arrow_head(at, end), kAxisColours[i], true);
    }
    if (handle.anchor) draw_path(painter_, line_path(point(*handle.anchor), at), colour, false);
    if (handle.role == HandleRole::direction && handle.anchor)
      draw_path(painter_, arrow_head(point(*handle.anchor), at), colour, true);
    else
      draw_path(painter_, circle_path(at, kKnob), colour, true);
    draw_label(text_of(handle.name), at + QPointF(10, -10), colour);
  }

 private:
  QPointF point(const Vec2d& pixel) const { return {pixel.x / ratio_, pixel.y / ratio_}; }

  /// Labels do not cover each other: a later one is lower.
  void draw_label(const QString& text, QPointF at, const QColor& colour) {
    const QFontMetricsF metrics(painter_.font());
    QRectF box = metrics.boundingRect(text).translated(at);
    for (int tries = 0; tries < 20; ++tries) {
      const auto covered = std::find_if(labels_.begin(), labels_.end(),
                                        [&](const QRectF& each) { return each.intersects(box); });
      if (covered == labels_.end()) break;
      at.ry() += covered->bottom() - box.top() + 1;
      box = metrics.boundingRect(text).translated(at);
    }
    labels_.push_back(box);
    QPainterPath path;
    path.addText(at, painter_.font(), text);
    painter_.setPen(QPen(kDark, 3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawPath(path);
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(colour);
    painter_.drawPath(path);
  }

  QPainter& painter_;
  double ratio_;
  std::vector<QRectF> labels_;
};

}  // namespace

void paint_overlay(QPainter& painter, const workbench::SceneOverlay& overlay,
                   const std::string& hovered, double ratio) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  OverlayPainter symbols(painter, ratio);
  for (const OverlayGizmo& each : overlay.gizmos) symbols.draw(each);
  for (const OverlayHandle& each : overlay.handles) symbols.draw(each, each.name == hovered);
  painter.restore();
}

}  // namespace vug::studio
