// SPDX-License-Identifier: Apache-2.0
// Input of the canvas; canvas_painting.cpp draws it.
#include "canvas.h"

#include <vug/image/io.h>
#include <vug/modeller/query.h>
#include <vug/workbench/words.h>

#include <fmt/format.h>
#include <QContextMenuEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <cmath>

namespace vug::studio {
namespace {

constexpr double kReach = 6;  // pixels from a handle at which it reacts

/// Positions are round for the magnification, decimetres with Ctrl, or millimetres with Shift.
double rounded(double metres, double scale, Qt::KeyboardModifiers keys) {
  if (keys & Qt::ShiftModifier) return workbench::snapped(metres, 1000);
  return workbench::snapped(metres, keys & Qt::ControlModifier ? 10 : scale);
}

}  // namespace

Canvas::Canvas(Studio& studio) : studio_(studio) {
  setObjectName("canvas");
  setAccessibleName(tr("Facade"));
  setAccessibleDescription(
      tr("The photo with the facade. Arrow keys select parts or move the selected handle."));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(320, 240);
  scale_length_ = new QLineEdit(this);
  scale_length_->setObjectName("scale length");
  scale_length_->setAccessibleName(tr("Length between the two points"));
  scale_length_->setPlaceholderText(tr("Length, e.g. 4.2m"));
  scale_length_->setFixedWidth(170);
  scale_length_->hide();
  connect(scale_length_, &QLineEdit::returnPressed, this, &Canvas::enter_scale);
  connect(&studio_, &Studio::opened, this, &Canvas::load_photo);
  connect(&studio_, &Studio::changed, this, &Canvas::changed);
  connect(&studio_, &Studio::hovered, this, &Canvas::changed);
}

void Canvas::load_photo() {
  photo_ = {};
  const std::string file = studio_.bench().photo().string();
  if (!file.empty() && !photo_.load(text_of(file))) {
    // Formats that Qt does not read, such as EXR.
    try {
      const std::string bytes = image::png_bytes(image::read(file, {.linear = true}));
      photo_.loadFromData(reinterpret_cast<const uchar*>(bytes.data()),
                          static_cast<int>(bytes.size()));
    } catch (const Error& error) {
      Q_EMIT studio_.message(text_of(error.what()), true);
    }
  }
  frame();
}

void Canvas::changed() {
  if (!drag_) hovered_.reset();
  update();
}

void Canvas::frame() {
  framed_ = true;
  if (has_document()) {
    const modeller::Canvas& size = studio_.bench().state().canvas();
    view() = workbench::CanvasView::whole(size.width, size.height, width(), height());
  }
  update();
}

void Canvas::resizeEvent(QResizeEvent*) {
  if (framed_) frame();
}

QPointF Canvas::at(double x, double y) const {
  return {view().to_canvas_x(x), view().to_canvas_y(y)};
}

std::optional<workbench::Handle> Canvas::handle_under(const QPointF& p) const {
  return workbench::handle_at(studio_.bench().current_handles(), to_x(p), to_y(p),
                              kReach / view().scale);
}

void Canvas::mousePressEvent(QMouseEvent* event) {
  if (!has_document()) return;
  const QPointF p = event->position();
  if (event->button() == Qt::MiddleButton ||
      (event->button() == Qt::LeftButton && event->modifiers() & Qt::AltModifier)) {
    pan_from_ = p;
    setCursor(Qt::ClosedHandCursor);
    return;
  }
  if (event->button() != Qt::LeftButton) return;
  if (scale_points_) return click_scale(p);
  if (const auto handle = handle_under(p)) {
    workbench::FacadeBench& bench = studio_.bench();
    bench.select_handle(handle->index, handle->instance);
    drag_ = Drag{*handle, workbench::numbers_node(bench.state(), bench.selected()), std::nullopt};
    update();
    return;
  }
  select_at(p);
}

void Canvas::select_at(const QPointF& p) {
  const modeller::FacadeState& state = studio_.bench().state();
  const auto hit = modeller::hit(state, to_x(p), to_y(p));
  if (!hit) return;
  // Each further click at the same place selects the part around the selected one.
  const int now = studio_.bench().selected();
  const bool again = last_click_ && (*last_click_ - p).manhattanLength() < 4 &&
                     last_revision_ == studio_.bench().revision();
  last_click_ = p, last_revision_ = studio_.bench().revision();
  for (int around = hit->node; again && around >= 0; around = state.node(around).parent)
    if (around == now && state.node(now).parent >= 0) return studio_.select(state.node(now).parent);
  studio_.select(hit->node);
}

void Canvas::mouseMoveEvent(QMouseEvent* event) {
  if (!has_document()) return;
  const QPointF p = event->position();
  Q_EMIT pointed(tr("x %1 m, y %2 m").arg(to_x(p), 0, 'f', 2).arg(to_y(p), 0, 'f', 2));
  if (pan_from_) {
    view() = view().panned(p.x() - pan_from_->x(), p.y() - pan_from_->y());
    pan_from_ = p;
    framed_ = false;
    return update();
  }
  if (drag_) return drag_to(p, event->modifiers());
  hovered_ = handle_under(p);
  show_cursor(p);
  update();
}

void Canvas::show_cursor(const QPointF&) {
  if (scale_points_) return setCursor(Qt::CrossCursor);
  if (!hovered_) return setCursor(Qt::ArrowCursor);
  setCursor(hovered_->upright ? Qt::SplitHCursor : Qt::SplitVCursor);
}

void Canvas::drag_to(const QPointF& p, Qt::KeyboardModifiers keys) {
  workbench::FacadeBench& bench = studio_.bench();
  const modeller::FacadeState& before = bench.document().state();
  const double to =
      rounded(workbench::own_position(before, drag_->node, drag_->handle, to_x(p), to_y(p)),
              view().scale, keys);
  const modeller::Edit edit = workbench::drag_edit(before, drag_->node, drag_->handle, to);
  if (bench.preview(edit)) drag_->edit = edit;
  Q_EMIT studio_.changed();
}

void Canvas::mouseReleaseEvent(QMouseEvent*) {
  pan_from_.reset();
  setCursor(Qt::ArrowCursor);
  if (!drag_) return;
  const Drag done = *drag_;
  drag_.reset();
  studio_.end_preview();
  if (done.edit) studio_.run(*done.edit);
}

void Canvas::mouseDoubleClickEvent(QMouseEvent* event) {
  if (has_document() && !scale_points_ && event->button() == Qt::LeftButton)
    toggle_cell(event->position());
}

/// Removes the window of a cell, or restores it.
void Canvas::toggle_cell(const QPointF& p) {
  const modeller::FacadeState& state = studio_.bench().state();
  const auto hit = modeller::hit(state, to_x(p), to_y(p));
  if (!hit) return;
  const int parent = state.node(hit->node).parent;
  if (!state.node(hit->node).element || parent < 0 || state.node(parent).split != "grid") return;
  const facade::PartKey& cell = state.planned(hit->node).place;
  studio_.run(fmt::format("toggle {} column={} row={}", state.path(parent), cell.column, cell.row));
}

void Canvas::contextMenuEvent(QContextMenuEvent* event) {
  if (!has_document()) return;
  select_at(event->pos());
  QMenu menu(this);
  const modeller::FacadeState& state = studio_.bench().state();
  const std::string path = state.path(studio_.bench().selected());
  const auto add = [&](const QString& title, const std::string& line) {
    connect(menu.addAction(title), &QAction::triggered, this, [this, line] { studio_.run(line); });
  };
  for (const modeller::ActionChoice& each : modeller::actions(state, studio_.bench().selected()))
    if (each.choice.reason == facade::Reason::none)
      add(text_of(each.action->name), "act " + path + " " + each.action->name);
  menu.addSeparator();
  add(tr("Retract rule"), "retract " + path);
  add(tr("Separate copies"), "separate " + path);
  add(tr("Join copies"), "join " + path);
  menu.exec(event->globalPos());
}

void Canvas::wheelEvent(QWheelEvent* event) {
  if (!has_document()) return;
  const double factor = std::pow(1.2, event->angleDelta().y() / 120.0);
  const QPointF p = event->position();
  framed_ = false;
  studio_.run(fmt::format("zoom {} {} {}", factor, p.x(), p.y()));
}

bool Canvas::move_selection(int key) {
  const char* which = key == Qt::Key_Left    ? "parent"
                      : key == Qt::Key_Right ? "child"
                      : key == Qt::Key_Up    ? "previous"
                      : key == Qt::Key_Down  ? "next"
                                             : nullptr;
  if (which) studio_.run(std::string("select ") + which);
  return which;
}

void Canvas::keyPressEvent(QKeyEvent* event) {
  const auto handle = has_document() ? studio_.bench().handle() : std::nullopt;
  const int key = event->key();
  if (key == Qt::Key_Escape) return cancel();
  if (!handle) {
    if (!has_document() || !move_selection(key)) QWidget::keyPressEvent(event);
    return;
  }
  const bool along = handle->upright ? key == Qt::Key_Left || key == Qt::Key_Right
                                     : key == Qt::Key_Up || key == Qt::Key_Down;
  if (!along) return QWidget::keyPressEvent(event);
  double by = event->modifiers() & Qt::ControlModifier ? 0.1
              : event->modifiers() & Qt::ShiftModifier ? 0.001
                                                       : 0.01;
  if (key == Qt::Key_Left || key == Qt::Key_Down) by = -by;
  studio_.run(fmt::format("nudge {}m", by));
}

void Canvas::cancel() {
  drag_.reset();
  scale_points_.reset();
  scale_length_->hide();
  if (!has_document()) return;
  studio_.bench().select_handle(std::nullopt);
  studio_.end_preview();
  show_cursor({});
}

void Canvas::begin_scale() {
  scale_points_.emplace();
  scale_length_->hide();
  setFocus();
  setCursor(Qt::CrossCursor);
  Q_EMIT studio_.message(tr("Click two points of known distance."), false);
  update();
}

void Canvas::click_scale(const QPointF& p) {
  if (scale_points_->size() == 2) scale_points_->clear();
  scale_points_->emplace_back(to_x(p), to_y(p));
  scale_length_->hide();
  if (scale_points_->size() == 2) {
    scale_length_->move((p + QPointF(12, 12)).toPoint());
    scale_length_->clear();
    scale_length_->show();
    scale_length_->setFocus();
  }
  update();
}

void Canvas::enter_scale() {
  if (!scale_points_ || scale_points_->size() != 2) return;
  const QPointF a = scale_points_->at(0), b = scale_points_->at(1);
  if (!studio_.run(fmt::format("scale {} {} {} {} {}", a.x(), a.y(), b.x(), b.y(),
                               workbench::quoted(scale_length_->text().toStdString()))))
    return;
  cancel();
  setFocus();
  frame();
}

}  // namespace vug::studio
