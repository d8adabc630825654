// SPDX-License-Identifier: Apache-2.0
// The picture of a scene in its window: it shows the last picture at any time, and turns mouse and
// keys into commands.
#pragma once

#include "scene_studio.h"

#include <QImage>
#include <QWidget>
#include <optional>

namespace vug::studio {

class ViewportWidget : public QWidget {
  Q_OBJECT
 public:
  explicit ViewportWidget(SceneStudio& studio);
  QSize sizeHint() const override { return {640, 480}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  /// A handle that the mouse holds; offsets count from the press.
  struct Grip {
    workbench::OverlayHit hit;
    QString drag;  ///< The drags of a press are one step.
  };
  void take_news();
  void send_size();
  void follow_overlay();
  /// A position of the mouse in pixels of the picture.
  Vec2d pixel_of(const QPointF& at) const;
  void drag_handle(const QPointF& at);
  void hover(const QPointF& at);
  void paint_region(QPainter& painter) const;
  void paint_wipe(QPainter& painter) const;
  /// Whether a position is on the edge of a wipe.
  bool is_on_edge(const QPointF& at) const;
  void follow_history();
  void send_region(const QRectF& box);
  void click(const QPointF& at, Qt::KeyboardModifiers modifiers);
  void move_view(const QPointF& by, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers);
  std::string pick_line(const QPointF& at) const;

  SceneStudio& studio_;
  viewport::PreviewPtr picture_;  ///< Owns the pixels of the image.
  QImage image_;
  std::shared_ptr<const workbench::ShownPicture> compared_;  ///< Instead of the picture.
  viewport::PreviewPtr compared_with_;
  uint64_t history_ = 0;
  bool moves_edge_ = false;
  bool stale_ = false, building_ = false;
  double fraction_ = 0;
  QString stage_;
  workbench::SceneOverlay overlay_;
  std::optional<Grip> grip_;
  std::string hovered_;
  int drags_ = 0;
  QPointF pressed_, last_;
  std::optional<QRectF> box_;  ///< The region that the mouse draws.
  bool moved_ = false;         ///< The button was pressed for a motion, not for a pick.
};

}  // namespace vug::studio
