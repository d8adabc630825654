// SPDX-License-Identifier: Apache-2.0
#include "viewport_widget.h"

#include "overlay_painter.h"
#include "studio.h"
#include "theme.h"

#include <vug/workbench/words.h>

#include <fmt/format.h>
#include <QContextMenuEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <cmath>
#include <utility>

namespace vug::studio {
namespace {

constexpr double kDegreesPerPixel = 0.4, kKeyDegrees = 5, kKeyPan = 0.05, kWheelStep = 0.85;
/// Pixels within which a press and a release are a click.
constexpr double kClick = 4;
/// Pixels of the window within which the mouse takes a handle.
constexpr double kReach = 9;
constexpr double kEdgeReach = 6;

}  // namespace

ViewportWidget::ViewportWidget(SceneStudio& studio) : studio_(studio) {
  setObjectName("viewport");
  setAccessibleName(tr("Picture of the scene"));
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(160, 120);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMouseTracking(true);
  setToolTip(tr("Drag to turn the view; click an object to find its declaration."));
  connect(&studio_, &SceneStudio::news, this, &ViewportWidget::take_news);
  connect(&studio_, &SceneStudio::analysed, this, &ViewportWidget::follow_overlay);
  connect(&studio_, &SceneStudio::changed, this, [this] {
    send_size();
    follow_history();
    follow_overlay();
  });
}

/// The kept picture or the comparison that is shown instead of the picture.
void ViewportWidget::follow_history() {
  const workbench::PictureHistory& history = studio_.bench().history();
  if (!image_.isNull() && history.revision() == history_ && compared_with_ == picture_) return;
  history_ = history.revision();
  compared_with_ = picture_;
  compared_ = history.displayed(picture_);
  const auto image_of = [](const auto& picture) {
    return QImage(picture.rgb.data(), picture.width, picture.height, 3 * picture.width,
                  QImage::Format_RGB888);
  };
  image_ = compared_ ? image_of(*compared_) : picture_ ? image_of(*picture_) : QImage();
  update();
}

bool ViewportWidget::is_on_edge(const QPointF& at) const {
  const workbench::PictureHistory& history = studio_.bench().history();
  return history.comparison() == workbench::ComparisonMode::wipe &&
         std::abs(at.x() - history.edge() * width()) < kEdgeReach;
}

/// The edge, and the numbers of both pictures next to it.
void ViewportWidget::paint_wipe(QPainter& painter) const {
  const workbench::PictureHistory& history = studio_.bench().history();
  if (history.comparison() != workbench::ComparisonMode::wipe) return;
  const double x = history.edge() * width();
  painter.fillRect(QRectF(x - 1.5, 0, 3, height()), QColor(0, 0, 0, 150));
  painter.fillRect(QRectF(x - 0.5, 0, 1, height()), Qt::white);
  const auto label = [&](const QString& letter, int number, bool left) {
    const QString text =
        number == 0 ? tr("%1: present").arg(letter) : tr("%1: picture %2").arg(letter).arg(number);
    QRectF box = painter.fontMetrics().boundingRect(text).adjusted(-6, -3, 6, 3);
    box.moveBottomLeft({left ? x - 8 - box.width() : x + 8, height() - 10.0});
    painter.fillRect(box, QColor(0, 0, 0, 170));
    painter.setPen(Qt::white);
    painter.drawText(box, Qt::AlignCenter, text);
  };
  label(tr("A"), history.shown(), true);
  label(tr("B"), history.reference(), false);
}

void ViewportWidget::take_news() {
  const workbench::SceneBench& bench = studio_.bench();
  const viewport::ViewportStatus status = bench.status();
  if (status.picture != picture_) {
    picture_ = status.picture;
  }
  follow_history();
  stale_ = bench.has_document() && bench.stale();
  building_ = status.building;
  fraction_ = status.fraction;
  stage_ = text_of(status.stage);
  // For scripts, and for screen readers.
  setProperty("stale", stale_ ? "yes" : "no");
  setProperty("version", picture_ ? static_cast<qulonglong>(picture_->scene.scene->version) : 0ull);
  setProperty("complete", picture_ && picture_->complete ? "yes" : "no");
  setAccessibleDescription(!picture_ ? tr("The first picture is not finished.")
                           : stale_  ? tr("The picture shows an earlier text.")
                                     : tr("The picture shows the present text."));
  follow_overlay();
  update();
}

/// While the user types, the symbols stay those of the last analysis: it is not repeated at each
/// key.
void ViewportWidget::follow_overlay() {
  const workbench::SceneBench& bench = studio_.bench();
  if (!bench.has_document() || (bench.needs_build() && !grip_)) return;
  overlay_ = bench.overlay();
  setProperty("handles", static_cast<int>(overlay_.handles.size()));
  update();
}

Vec2d ViewportWidget::pixel_of(const QPointF& at) const {
  const double ratio = devicePixelRatioF();
  return {at.x() * ratio, at.y() * ratio};
}

void ViewportWidget::send_size() {
  if (!studio_.bench().has_document()) return;
  const double ratio = devicePixelRatioF();
  studio_.bench().viewport().set_size(static_cast<int>(std::lround(width() * ratio)),
                                      static_cast<int>(std::lround(height() * ratio)));
}

void ViewportWidget::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  send_size();
}

void ViewportWidget::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), theme().canvas);
  if (!image_.isNull()) {
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(rect(), image_);
    const workbench::PictureHistory& history = studio_.bench().history();
    if (history.shown() == 0 && history.comparison() != workbench::ComparisonMode::difference)
      paint_overlay(painter, overlay_, grip_ ? grip_->hit.name : hovered_, devicePixelRatioF());
  }
  QString note;
  if (!picture_)
    note =
        building_ ? tr("Vug builds the first picture.") : tr("The first picture is not finished.");
  else if (stale_)
    note = building_ ? tr("Earlier text. Building: %1").arg(stage_)
                     : tr("Earlier text: the present one has errors or was stopped.");
  if (!note.isEmpty()) {
    const QRect box = painter.fontMetrics().boundingRect(note).adjusted(-8, -5, 8, 5);
    const QRect place(QPoint(10, 10), box.size());
    painter.fillRect(place, theme().window);
    painter.setPen(theme().text);
    painter.drawText(place, Qt::AlignCenter, note);
  }
  paint_region(painter);
  paint_wipe(painter);
  if (building_) painter.fillRect(QRectF(0, height() - 3, width() * fraction_, 3), theme().accent);
  if (hasFocus()) {
    painter.setPen(theme().accent);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
}

/// The pixels outside of the region are darker, since they may be older.
void ViewportWidget::paint_region(QPainter& painter) const {
  const workbench::SceneBench& bench = studio_.bench();
  if (!bench.has_document()) return;
  std::optional<QRectF> shown = box_;
  if (const auto& box = bench.viewport().request().region; box && !shown)
    shown = QRectF(QPointF(box->x0 * width(), box->y0 * height()),
                   QPointF(box->x1 * width(), box->y1 * height()));
  if (!shown) return;
  QPainterPath outside;
  outside.addRect(rect());
  outside.addRect(*shown);
  painter.fillPath(outside, QColor(0, 0, 0, 90));
  painter.setPen(QPen(Qt::black, 1));
  painter.drawRect(*shown);
  painter.setPen(QPen(Qt::white, 1, Qt::DashLine));
  painter.drawRect(*shown);
}

void ViewportWidget::send_region(const QRectF& box) {
  const QRectF inside = box.normalized() & QRectF(rect());
  if (inside.isEmpty()) return update();
  studio_.run(fmt::format("region {:.5f} {:.5f} {:.5f} {:.5f}", inside.left() / width(),
                          inside.top() / height(), inside.right() / width(),
                          inside.bottom() / height()));
}

std::string ViewportWidget::pick_line(const QPointF& at) const {
  return fmt::format("pick {:.5f} {:.5f}", at.x() / width(), at.y() / height());
}

void ViewportWidget::mousePressEvent(QMouseEvent* event) {
  pressed_ = last_ = event->position();
  moved_ = false;
  grip_.reset();
  box_.reset();
  moves_edge_ = false;
  if (event->button() != Qt::LeftButton || event->modifiers() != Qt::NoModifier) return;
  moves_edge_ = is_on_edge(pressed_);
  if (moves_edge_) return;
  if (const auto hit = handle_at(overlay_, pixel_of(pressed_), kReach * devicePixelRatioF()))
    grip_ = Grip{*hit, QString("drag %1").arg(++drags_)};
}

void ViewportWidget::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() == Qt::NoButton) return hover(event->position());
  const QPointF by = event->position() - last_;
  if (!moved_ && (event->position() - pressed_).manhattanLength() < kClick) return;
  moved_ = true;
  last_ = event->position();
  if (grip_) return drag_handle(last_);
  if (moves_edge_)
    return static_cast<void>(studio_.run(fmt::format("wipe {:.4f}", last_.x() / width())));
  if (event->buttons() == Qt::LeftButton && event->modifiers() == Qt::ShiftModifier) {
    box_ = QRectF(pressed_, last_);
    return update();
  }
  move_view(by, event->buttons(), event->modifiers());
}

void ViewportWidget::move_view(const QPointF& by, Qt::MouseButtons buttons,
                               Qt::KeyboardModifiers modifiers) {
  if (modifiers & Qt::ControlModifier)
    studio_.run(fmt::format("dolly {:.5f}", std::exp(by.y() / height())));
  else if (buttons & Qt::MiddleButton || modifiers & Qt::AltModifier)
    studio_.run(fmt::format("pan {:.5f} {:.5f}", -by.x() / height(), by.y() / height()));
  else if (buttons & Qt::LeftButton)
    studio_.run(
        fmt::format("orbit {:.3f} {:.3f}", by.x() * kDegreesPerPixel, by.y() * kDegreesPerPixel));
}

void ViewportWidget::drag_handle(const QPointF& at) {
  const Vec2d offset = pixel_of(at) - pixel_of(pressed_);
  const std::optional<int> axis = grip_->hit.axis;
  studio_.run(fmt::format("drag_handle {} {:.3f} {:.3f} {} {}", workbench::quoted(grip_->hit.name),
                          offset.x, offset.y, axis ? std::string(1, "xyz"[*axis]) : "-",
                          workbench::quoted(grip_->drag.toStdString())));
}

void ViewportWidget::hover(const QPointF& at) {
  const auto hit = handle_at(overlay_, pixel_of(at), kReach * devicePixelRatioF());
  const std::string name = hit ? hit->name : "";
  setCursor(is_on_edge(at) ? Qt::SplitHCursor : hit ? Qt::SizeAllCursor : Qt::ArrowCursor);
  if (name == hovered_) return;
  hovered_ = name;
  update();
}

void ViewportWidget::leaveEvent(QEvent* event) {
  hovered_.clear();
  QWidget::leaveEvent(event);
  update();
}

void ViewportWidget::mouseReleaseEvent(QMouseEvent* event) {
  const bool dragged = grip_ && moved_;
  grip_.reset();
  if (const auto box = std::exchange(box_, std::nullopt))
    send_region(*box);
  else if (dragged)
    studio_.run("end_step");
  else if (!moved_ && event->button() == Qt::LeftButton)
    click(event->position(), event->modifiers());
}

/// A symbol is above the objects. Ctrl reads the pixel, and with Shift goes to its material.
void ViewportWidget::click(const QPointF& at, Qt::KeyboardModifiers modifiers) {
  if (modifiers == Qt::NoModifier && studio_.bench().viewport().request().region)
    return static_cast<void>(studio_.run("region"));
  if (modifiers & Qt::ControlModifier) {
    studio_.run(fmt::format("inspect {:.5f} {:.5f}", at.x() / width(), at.y() / height()));
    if (modifiers & Qt::ShiftModifier) studio_.run("go_material");
    return;
  }
  const auto* gizmo = gizmo_at(overlay_, pixel_of(at), kReach * devicePixelRatioF());
  const bool own = gizmo && gizmo->where.file == studio_.bench().file().string();
  studio_.run(own ? fmt::format("go {} {}", gizmo->where.line, gizmo->where.column)
                  : pick_line(at));
}

void ViewportWidget::contextMenuEvent(QContextMenuEvent* event) {
  if (moved_ || !studio_.run(pick_line(event->pos()))) return;
  const auto& picked = studio_.bench().picked();
  if (!picked) return;
  QMenu menu(this);
  menu.setAccessibleName(tr("Declarations"));
  for (size_t i = 0; i < picked->declared.size(); ++i) {
    const viewport::DeclaredPlace& each = picked->declared[i];
    menu.addAction(
        tr("%1 %2, line %3").arg(text_of(each.kind), text_of(each.name)).arg(each.where.line),
        [this, i] {
          studio_.bench().select_declaration(i);
          Q_EMIT studio_.changed();
        });
  }
  if (!menu.isEmpty()) menu.exec(event->globalPos());
}

void ViewportWidget::wheelEvent(QWheelEvent* event) {
  studio_.run(fmt::format("dolly {:.5f}", std::pow(kWheelStep, event->angleDelta().y() / 120.0)));
  event->accept();
}

void ViewportWidget::keyPressEvent(QKeyEvent* event) {
  const auto turn = [&](double yaw, double pitch) {
    if (event->modifiers() & Qt::ShiftModifier)
      studio_.run(fmt::format("pan {} {}", yaw * kKeyPan, pitch * kKeyPan));
    else
      studio_.run(fmt::format("orbit {} {}", yaw * kKeyDegrees, pitch * kKeyDegrees));
  };
  switch (event->key()) {
    case Qt::Key_Left:
      return turn(-1, 0);
    case Qt::Key_Right:
      return turn(1, 0);
    case Qt::Key_Up:
      return turn(0, 1);
    case Qt::Key_Down:
      return turn(0, -1);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return static_cast<void>(studio_.run(fmt::format("dolly {}", kWheelStep)));
    case Qt::Key_Minus:
      return static_cast<void>(studio_.run(fmt::format("dolly {}", 1 / kWheelStep)));
    case Qt::Key_Return:
      return static_cast<void>(studio_.run("pick 0.5 0.5"));
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace vug::studio
