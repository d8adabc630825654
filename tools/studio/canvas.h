// SPDX-License-Identifier: Apache-2.0
// The canvas: the photo with the facade over it, its handles, and the mouse and keys that move
// them.
#pragma once

#include "studio.h"

#include <QImage>
#include <QWidget>
#include <optional>

class QLineEdit;

namespace vug::studio {

class Canvas : public QWidget {
  Q_OBJECT
 public:
  explicit Canvas(Studio& studio);

  /// Shows the whole facade.
  void frame();
  /// Waits for two clicks whose distance the user then enters.
  void begin_scale();
  /// A point on the canvas, in pixels, of a point on the facade's plane.
  QPointF at(double x, double y) const;
  /// Ends what the mouse does: a drag, the setting of the scale, the selection of a handle.
  void cancel();

 Q_SIGNALS:
  void pointed(const QString& text);  ///< Position of the mouse, for the status bar.

 protected:
  void paintEvent(QPaintEvent*) override;
  void resizeEvent(QResizeEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void mouseDoubleClickEvent(QMouseEvent*) override;
  void contextMenuEvent(QContextMenuEvent*) override;
  void wheelEvent(QWheelEvent*) override;
  void keyPressEvent(QKeyEvent*) override;

 private:
  using Handle = workbench::Handle;
  struct Drag {
    Handle handle;
    int node = 0;
    std::optional<modeller::Edit> edit;  ///< The last one that could be previewed.
  };

  void load_photo();
  void changed();
  workbench::CanvasView& view() { return studio_.bench().view().canvas; }
  const workbench::CanvasView& view() const { return studio_.bench().view().canvas; }
  bool has_document() const { return studio_.bench().has_document(); }
  double to_x(const QPointF& p) const { return view().to_facade_x(p.x()); }
  double to_y(const QPointF& p) const { return view().to_facade_y(p.y()); }
  std::optional<Handle> handle_under(const QPointF& p) const;
  void drag_to(const QPointF& p, Qt::KeyboardModifiers keys);
  void select_at(const QPointF& p);
  void click_scale(const QPointF& p);
  void enter_scale();
  void show_cursor(const QPointF& p);
  void toggle_cell(const QPointF& p);
  bool move_selection(int key);

  void paint_photo(QPainter& painter);
  void paint_shapes(QPainter& painter);
  void paint_ghosts(QPainter& painter);
  void paint_selection(QPainter& painter);
  void paint_handles(QPainter& painter);
  void paint_scale(QPainter& painter);
  void paint_welcome(QPainter& painter);
  void paint_bubble(QPainter& painter, const QPointF& p, const QString& text);
  QRectF box(const facade::Rect& rect) const;

  Studio& studio_;
  QImage photo_;
  QImage mask_;
  uint64_t mask_revision_ = 0, last_revision_ = 0;
  bool framed_ = false;  ///< The view is that of `frame`, so that it follows the size.
  std::optional<Drag> drag_;
  std::optional<Handle> hovered_;
  std::optional<QPointF> pan_from_, last_click_;
  std::optional<std::vector<QPointF>> scale_points_;  ///< In metres, while the scale is set.
  QLineEdit* scale_length_ = nullptr;
};

}  // namespace vug::studio
