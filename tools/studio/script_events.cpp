// SPDX-License-Identifier: Apache-2.0
// Events of scripts. Positions on the canvas are in metres on the facade's plane.
#include "script_runner.h"

#include <vug/base/diagnostics.h>
#include <vug/workbench/words.h>

#include <fmt/format.h>
#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QTest>
#include <QWheelEvent>
#include <map>

namespace vug::studio {
namespace {

using Words = std::vector<std::string>;

QPoint canvas_point(MainWindow& window, const std::string& x, const std::string& y) {
  return window.canvas().at(workbench::parse_length(x), workbench::parse_length(y)).toPoint();
}

void require(const Words& words, size_t least, const char* usage) {
  if (words.size() < least)
    throw Error(ErrorCode::bad_input, fmt::format("wrong number of arguments of {}", words[0]), {},
                usage);
}

/// click canvas X Y [middle] | click WIDGET
void click(MainWindow& window, const Words& words) {
  require(words, 2, "click canvas X Y, or click WIDGET");
  const bool twice = words[0] == "double-click";
  const auto send = [&](QWidget& widget, const QPoint& at) {
    if (twice)
      QTest::mouseDClick(&widget, Qt::LeftButton, {}, at);
    else
      QTest::mouseClick(&widget, Qt::LeftButton, {}, at);
  };
  if (words[1] == "canvas" && words.size() >= 4) {
    const QPoint at = canvas_point(window, words[2], words[3]);
    QTest::mouseMove(&window.canvas(), at);
    return send(window.canvas(), at);
  }
  QWidget& widget = find_widget(words[1]);
  // A check box reacts at its box and its text, which may end before the middle.
  const bool box = qobject_cast<const QCheckBox*>(&widget) != nullptr;
  send(widget, box ? QPoint(10, widget.height() / 2) : widget.rect().center());
}

/// drag line N [copy K] to LENGTH
void drag(Studio& studio, MainWindow& window, const Words& words) {
  require(words, 5, "drag line N [copy K] to LENGTH");
  const auto index = static_cast<size_t>(workbench::parse_number(words[2]));
  size_t instance = 0, at = 3;
  if (words[at] == "copy" && words.size() > at + 1) {
    instance = static_cast<size_t>(workbench::parse_number(words[at + 1]));
    at += 2;
  }
  if (words.size() != at + 2 || words[1] != "line" || words[at] != "to")
    throw Error(ErrorCode::bad_input, "invalid drag", {}, "drag line N [copy K] to LENGTH");
  const double to = workbench::parse_length(words[at + 1]);
  for (const workbench::Handle& each : studio.bench().current_handles()) {
    if (each.index != index || each.instance != instance) continue;
    // Motion along the handle's axis; mirrored copies move to the other side.
    const modeller::FacadeState& state = studio.bench().state();
    const int node = workbench::numbers_node(state, studio.bench().selected());
    const double ahead =
        workbench::own_position(state, node, each, each.x0 + 1, each.y0 + 1) - each.at;
    const double x = (each.x0 + each.x1) / 2, y = (each.y0 + each.y1) / 2;
    const double by = (to - each.at) / ahead;
    Canvas& canvas = window.canvas();
    const auto point = [&](double share) {
      return (each.upright ? canvas.at(x + share * by, y) : canvas.at(x, y + share * by)).toPoint();
    };
    QTest::mouseMove(&canvas, point(0));
    QTest::mousePress(&canvas, Qt::LeftButton, {}, point(0));
    for (const double share : {0.25, 0.5, 0.75, 1.0}) QTest::mouseMove(&canvas, point(share));
    QTest::mouseRelease(&canvas, Qt::LeftButton, {}, point(1));
    return;
  }
  throw Error(ErrorCode::bad_input, fmt::format("the selected part has no handle {}", index), {},
              "select a part with free numbers");
}

/// The widget that receives keys: the one with the focus.
QWidget& focused(MainWindow& window) {
  if (QWidget* modal = QApplication::activeModalWidget()) {
    QWidget* inside = modal->focusWidget();
    return inside ? *inside : *modal;
  }
  QWidget* widget = window.focusWidget();
  return widget ? *widget : window;
}

void press_keys(MainWindow& window, const Words& words) {
  require(words, 2, "key Ctrl+Z");
  // Keys of actions need an active window; without a window manager, closing a dialog leaves none.
  if (!QApplication::activeModalWidget() && !window.isActiveWindow()) {
    window.activateWindow();
    static_cast<void>(QTest::qWaitForWindowActive(&window, 1000));
  }
  for (size_t i = 1; i < words.size(); ++i) {
    const QKeySequence keys(text_of(words[i]), QKeySequence::PortableText);
    if (keys.isEmpty() || keys[0].key() == Qt::Key_unknown)
      throw Error(ErrorCode::bad_input, fmt::format("unknown key '{}'", words[i]));
    QTest::keyClick(&focused(window), keys[0].key(), keys[0].keyboardModifiers());
  }
}

/// wheel X Y STEPS: over a point of the canvas.
void wheel(MainWindow& window, const Words& words) {
  require(words, 4, "wheel X Y STEPS");
  Canvas& canvas = window.canvas();
  const QPoint at = canvas_point(window, words[1], words[2]);
  QWheelEvent event(at, canvas.mapToGlobal(at), {},
                    {0, static_cast<int>(120 * workbench::parse_number(words[3]))}, Qt::NoButton,
                    {}, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&canvas, &event);
}

void hover(MainWindow& window, const Words& words) {
  require(words, 2, "hover canvas X Y, or hover WIDGET");
  if (words[1] == "canvas" && words.size() >= 4) {
    QTest::mouseMove(&window.canvas(), canvas_point(window, words[2], words[3]));
    return;
  }
  QWidget& widget = find_widget(words[1]);
  const QPointF at = widget.rect().center();
  QEnterEvent enter(at, widget.mapTo(widget.window(), at), widget.mapToGlobal(at));
  QApplication::sendEvent(&widget, &enter);
}

}  // namespace

bool send_events(Studio& studio, MainWindow& window, const Words& words) {
  const std::string& name = words[0];
  if (name == "click" || name == "double-click")
    click(window, words);
  else if (name == "drag")
    drag(studio, window, words);
  else if (name == "key")
    press_keys(window, words);
  else if (name == "wheel")
    wheel(window, words);
  else if (name == "hover")
    hover(window, words);
  else if (name == "focus" && words.size() == 2)
    find_widget(words[1]).setFocus();
  else if (name == "type" && words.size() == 2)
    QTest::keyClicks(&focused(window), text_of(words[1]));
  else
    return false;
  return true;
}

}  // namespace vug::studio
