// SPDX-License-Identifier: Apache-2.0
#include "canvas.h"
#include "theme.h"

#include <vug/modeller/query.h>
#include <vug/workbench/action_reason.h>

#include <QPainter>
#include <QPainterPath>

namespace vug::studio {
namespace {

QColor with_alpha(QColor colour, double alpha) {
  colour.setAlphaF(static_cast<float>(alpha));
  return colour;
}

/// A dotted line that is visible over bright and dark photos.
void dotted_line(QPainter& painter, const QPointF& a, const QPointF& b, const QColor& colour,
                 double width) {
  painter.setPen(QPen(QColor(0, 0, 0, 150), width + 1.6, Qt::SolidLine, Qt::FlatCap));
  painter.drawLine(a, b);
  QPen dots(colour, width, Qt::CustomDashLine, Qt::FlatCap);
  dots.setDashPattern({3, 2});
  painter.setPen(dots);
  painter.drawLine(a, b);
}

}  // namespace

QRectF Canvas::box(const facade::Rect& rect) const {
  return {at(rect.x, rect.top()), at(rect.right(), rect.y)};
}

void Canvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), theme().canvas);
  painter.setRenderHint(QPainter::Antialiasing);
  if (!has_document()) return paint_welcome(painter);
  paint_photo(painter);
  paint_shapes(painter);
  paint_selection(painter);
  paint_ghosts(painter);
  paint_handles(painter);
  paint_scale(painter);
}

void Canvas::paint_welcome(QPainter& painter) {
  QFont large = font();
  large.setPointSizeF(1.6 * large.pointSizeF());
  painter.setPen(theme().text);
  painter.setFont(large);
  painter.drawText(rect().adjusted(0, 0, 0, -40), Qt::AlignCenter, tr("Open a photo of a facade"));
  painter.setFont(font());
  painter.setPen(theme().muted);
  painter.drawText(rect().adjusted(0, 40, 0, 0), Qt::AlignCenter,
                   tr("Ctrl+N opens a photo, Ctrl+O a session"));
}

void Canvas::paint_photo(QPainter& painter) {
  const modeller::Canvas& size = studio_.bench().state().canvas();
  const QRectF whole = box({0, 0, size.width, size.height});
  painter.fillRect(whole, theme().panel);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.setOpacity(studio_.bench().view().opacity);
  if (!photo_.isNull()) painter.drawImage(whole, photo_);
  painter.setOpacity(1);
  const auto& score = studio_.bench().score();
  if (!studio_.bench().view().differences || !score) return;
  if (mask_revision_ != studio_.bench().revision() || mask_.isNull()) {
    const fit::FacadeScorer& scorer = *studio_.bench().scorer();
    mask_ = QImage(scorer.width(), scorer.height(), QImage::Format_ARGB32);
    const QRgb marked = with_alpha(theme().difference, 0.75).rgba();
    for (int y = 0; y < mask_.height(); ++y)
      for (int x = 0; x < mask_.width(); ++x)
        mask_.setPixel(x, y, score->mask[static_cast<size_t>(y * mask_.width() + x)] ? marked : 0);
    mask_revision_ = studio_.bench().revision();
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
  painter.drawImage(whole, mask_);
}

void Canvas::paint_shapes(QPainter& painter) {
  using Kind = workbench::Shape::Kind;
  for (const workbench::Shape& each : workbench::shapes(studio_.bench().state())) {
    const QRectF where = box(each.rect);
    if (each.kind == Kind::element) {
      const QColor colour = colour_of(each.symbol);
      painter.setBrush(with_alpha(colour, each.first ? 0.3 : 0.2));
      painter.setPen(QPen(QColor(255, 255, 255, 200), 3));
      painter.drawRect(where);
      painter.setPen(QPen(colour, 1.6));
    } else if (each.kind == Kind::open) {
      painter.setBrush(with_alpha(theme().open, 0.07));
      painter.setPen(QPen(with_alpha(theme().open, 0.95), 1.4));
    } else {
      painter.setBrush(Qt::NoBrush);
      painter.setPen(QPen(QColor(255, 255, 255, 110), 1));
    }
    painter.drawRect(where);
  }
}

void Canvas::paint_ghosts(QPainter& painter) {
  const workbench::FacadeBench& bench = studio_.bench();
  painter.setBrush(with_alpha(theme().ghost, 0.16));
  painter.setPen(QPen(theme().ghost, 1.6, Qt::DashLine));
  if (bench.fitting() && bench.best_tree())
    for (const facade::ElementInstance& each : facade::element_instances(*bench.best_tree()))
      painter.drawRect(box(each.rect));
  const auto& all = bench.state().style().actions();
  const auto hovered = static_cast<size_t>(studio_.hovered_action());
  if (studio_.hovered_action() < 0 || hovered >= all.size()) return;
  const int node = bench.selected();
  try {
    const modeller::FacadeState after = modeller::perform_edit(
        bench.state(), workbench::action_edit(bench.state(), node, all[hovered]));
    for (const workbench::Shape& each : workbench::ghosts(bench.state(), node, after)) {
      const bool element = after.node(each.node).element != nullptr;
      painter.setBrush(element ? QBrush(with_alpha(theme().ghost, 0.3)) : QBrush(Qt::NoBrush));
      painter.setPen(QPen(QColor(255, 255, 255, 200), 3));
      painter.drawRect(box(each.rect));
      painter.setPen(QPen(theme().ghost, 1.8, Qt::DashLine));
      painter.drawRect(box(each.rect));
    }
  } catch (const Error&) {
    // An action that is not available has no ghost; its tooltip gives the reason.
  }
}

void Canvas::paint_selection(QPainter& painter) {
  const workbench::FacadeBench& bench = studio_.bench();
  painter.setBrush(Qt::NoBrush);
  bool first = true;
  for (const facade::Rect& each : workbench::instances(bench.state(), bench.selected())) {
    const QRectF where = box(each);
    painter.setPen(QPen(QColor(255, 255, 255, 220), first ? 4.5 : 3));
    painter.drawRect(where);
    painter.setPen(QPen(theme().accent, first ? 2.4 : 1.4));
    painter.drawRect(where);
    first = false;
  }
}

void Canvas::paint_handles(QPainter& painter) {
  const workbench::FacadeBench& bench = studio_.bench();
  const auto selected = bench.handle();
  const std::vector<Handle> all = bench.current_handles();
  for (const Handle& each : all) {
    const bool same = selected && selected->index == each.index;
    const bool hot = same || (hovered_ && hovered_->index == each.index);
    const QPointF a = at(each.x0, each.y0), b = at(each.x1, each.y1);
    dotted_line(painter, a, b, hot ? QColor(Qt::white) : theme().line, hot ? 2.6 : 1.6);
    const QPointF grip = each.line ? b : (a + b) / 2;
    painter.setPen(QPen(QColor(0, 0, 0, 170), 1));
    painter.setBrush(hot ? QColor(Qt::white) : theme().line);
    if (each.line)
      painter.drawEllipse(grip, 4, 4);
    else
      painter.drawRect(QRectF(grip - QPointF(4, 4), QSizeF(8, 8)));
  }
  const auto shown = selected ? selected : hovered_;
  if (!shown) return;
  for (const Handle& each : all)
    if (each.index == shown->index && each.instance == shown->instance)
      paint_bubble(painter, (at(each.x0, each.y0) + at(each.x1, each.y1)) / 2,
                   QString("%1  %2 m")
                       .arg(text_of(each.number))
                       .arg(each.line ? each.at : each.at - each.origin, 0, 'f', 2));
}

void Canvas::paint_bubble(QPainter& painter, const QPointF& p, const QString& text) {
  const QSizeF size = fontMetrics().boundingRect(text).size() + QSize(18, 8);
  QRectF where(p + QPointF(12, -size.height() / 2), size);
  if (where.right() > width() - 4) where.moveRight(p.x() - 12);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(20, 22, 26, 225));
  painter.drawRoundedRect(where, 6, 6);
  painter.setPen(Qt::white);
  painter.drawText(where, Qt::AlignCenter, text);
}

void Canvas::paint_scale(QPainter& painter) {
  if (!scale_points_) return;
  painter.setPen(QPen(theme().accent, 2));
  painter.setBrush(Qt::white);
  std::vector<QPointF> points;
  for (const QPointF& each : *scale_points_) points.push_back(at(each.x(), each.y()));
  if (points.size() == 2) painter.drawLine(points[0], points[1]);
  for (const QPointF& each : points) painter.drawEllipse(each, 4.5, 4.5);
}

}  // namespace vug::studio
