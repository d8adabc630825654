// SPDX-License-Identifier: Apache-2.0
// Pictograms of actions: a small facade divided by the rule.
#include "theme.h"

#include <QPainter>
#include <vector>

namespace vug::studio {
namespace {

constexpr int kSize = 32;  // device-independent pixels

/// Windows of a grid: uneven distances unless it is regular, unequal sizes unless it is identical.
std::vector<QRectF> grid_windows(bool regular, bool identical) {
  const std::vector<double> x =
      regular ? std::vector<double>{5, 13.5, 22} : std::vector<double>{5, 11.5, 22};
  const std::vector<double> y = regular ? std::vector<double>{6, 18} : std::vector<double>{6, 19};
  std::vector<QRectF> out;
  for (size_t row = 0; row < y.size(); ++row)
    for (size_t column = 0; column < x.size(); ++column) {
      const bool small = !identical && (row + column) % 2 == 1;
      out.emplace_back(x[column], y[row] + (small ? 2 : 0), small ? 3.5 : 5, small ? 5 : 7);
    }
  return out;
}

void draw_mirror(QPainter& painter, bool middle) {
  painter.drawRect(QRectF(4, 9, 4, 8));
  painter.drawRect(QRectF(24, 9, 4, 8));
  QPen dotted = painter.pen();
  dotted.setStyle(Qt::DotLine);
  painter.setPen(dotted);
  if (middle) {
    painter.drawLine(QPointF(11.5, 3), QPointF(11.5, 29));
    painter.drawLine(QPointF(20.5, 3), QPointF(20.5, 29));
  } else {
    painter.drawLine(QPointF(16, 3), QPointF(16, 29));
  }
}

void draw(QPainter& painter, const QString& action) {
  painter.drawRoundedRect(QRectF(1.5, 2.5, 29, 27), 2, 2);
  if (action.endsWith("Grid")) {
    for (const QRectF& each :
         grid_windows(action.contains("Regular"), action.contains("Identical")))
      painter.drawRect(each);
  } else if (action.startsWith("rows")) {
    painter.drawLine(QPointF(1.5, 20), QPointF(30.5, 20));
  } else if (action.startsWith("mirror")) {
    draw_mirror(painter, action.contains(','));
  } else if (action.startsWith("repeat") || action.startsWith("columns")) {
    const bool even = !action.contains("Element");
    for (const double x : even ? std::vector<double>{11.2, 20.8} : std::vector<double>{8, 21})
      painter.drawLine(QPointF(x, 2.5), QPointF(x, 29.5));
  } else {
    painter.drawRect(QRectF(9, 9, 14, 14));
  }
}

}  // namespace

QIcon action_icon(const QString& action, bool available) {
  QIcon out;
  for (const int scale : {1, 2}) {
    QPixmap pixmap(kSize * scale, kSize * scale);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.scale(scale, scale);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setOpacity(available ? 1 : 0.45);
    painter.setPen(QPen(available ? theme().accent : theme().muted, 1.4));
    draw(painter, action);
    painter.end();
    pixmap.setDevicePixelRatio(scale);
    out.addPixmap(pixmap);
    out.addPixmap(pixmap, QIcon::Disabled);
  }
  return out;
}

}  // namespace vug::studio
