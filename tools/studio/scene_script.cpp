// SPDX-License-Identifier: Apache-2.0
#include "scene_script.h"

#include "script_runner.h"

#include <vug/base/error.h>
#include <vug/workbench/scene_query.h>
#include <vug/workbench/words.h>

#include <QTest>

namespace vug::studio {
namespace {

using Words = std::vector<std::string>;

/// A position of the picture, 0..1.
QPoint picture_point(const QWidget& viewport, const std::string& x, const std::string& y) {
  return {static_cast<int>(workbench::parse_number(x) * viewport.width()),
          static_cast<int>(workbench::parse_number(y) * viewport.height())};
}

/// Presses the left button, moves in steps and releases it.
void drag_mouse(QWidget& viewport, const QPoint& from, const QPoint& to,
                Qt::KeyboardModifiers keys) {
  QTest::mousePress(&viewport, Qt::LeftButton, keys, from);
  for (int step = 1; step <= 8; ++step) {
    const QPoint at = from + (to - from) * step / 8;
    QMouseEvent move(QEvent::MouseMove, at, viewport.mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                     keys);
    QApplication::sendEvent(&viewport, &move);
  }
  QTest::mouseRelease(&viewport, Qt::LeftButton, keys, to);
}

/// drag handle NAME DX DY [x|y|z]: by pixels of the window, at the grip or at the end of an axis.
void drag_handle_by_mouse(QWidget& viewport, const workbench::SceneBench& bench,
                          const Words& words) {
  require_words(words, 5, "drag handle NAME DX DY [x|y|z]");
  const double ratio = viewport.devicePixelRatioF();
  for (const workbench::OverlayHandle& each : bench.overlay().handles) {
    if (each.name != words[2]) continue;
    const std::string axis = words.size() > 5 ? words[5] : "";
    const std::optional<Vec2d> at =
        axis.empty() ? std::optional(each.at) : each.axes.at(static_cast<size_t>(axis[0] - 'x'));
    if (!at) break;
    const QPointF from(at->x / ratio, at->y / ratio);
    const QPointF by(workbench::parse_number(words[3]), workbench::parse_number(words[4]));
    return drag_mouse(viewport, from.toPoint(), (from + by).toPoint(), Qt::NoModifier);
  }
  throw Error(ErrorCode::bad_input, "the picture shows no handle '" + words[2] + "'", {},
              "go to its statement, and turn the view until it is visible");
}

/// click symbol NAME: that of a light or a camera.
void click_symbol(QWidget& viewport, const workbench::SceneBench& bench, const Words& words) {
  const double ratio = viewport.devicePixelRatioF();
  for (const workbench::OverlayGizmo& each : bench.overlay().gizmos)
    if (each.name == words[2])
      return QTest::mouseClick(&viewport, Qt::LeftButton, {},
                               QPointF(each.at.x / ratio, each.at.y / ratio).toPoint());
  throw Error(ErrorCode::bad_input, "the picture shows no symbol '" + words[2] + "'", {},
              "turn the view until the light or the camera is visible");
}

/// drag viewport X Y to X Y [shift|ctrl|alt]
void drag_picture(QWidget& viewport, const Words& words) {
  require_words(words, 7, "drag viewport X Y to X Y [shift|ctrl|alt]");
  const QPoint from = picture_point(viewport, words[2], words[3]);
  const QPoint to = picture_point(viewport, words[5], words[6]);
  const std::string modifier = words.size() > 7 ? words[7] : "";
  const Qt::KeyboardModifiers keys = modifier == "shift"  ? Qt::ShiftModifier
                                     : modifier == "ctrl" ? Qt::ControlModifier
                                     : modifier == "alt"  ? Qt::AltModifier
                                                          : Qt::NoModifier;
  drag_mouse(viewport, from, to, keys);
}

}  // namespace

/// Values of the widgets: `squiggle N` is the text below a squiggle, `meaning LINE COLUMN` the
/// class of a word, `caret` the position in the editor, `shown` the text of the editor.
void SceneScript::expect(const Words& words) {
  const auto compare = [&](const std::string& actual, size_t arguments) {
    require_words(words, arguments + 3, "expect NAME = TEXT");
    workbench::expect_value(words[0], actual, words[arguments + 1], words[arguments + 2]);
  };
  SceneEditor& editor = window_.editor();
  const auto number = [&](size_t index) {
    require_words(words, index + 1, "expect NAME NUMBER = TEXT");
    return static_cast<int>(workbench::parse_number(words[index]));
  };
  const std::string name = words.empty() ? "" : words[0];
  if (name == "squiggle") {
    compare(editor.squiggles().value(number(1)).toStdString(), 1);
  } else if (name == "squiggles") {
    compare(std::to_string(editor.squiggles().size()), 0);
  } else if (name == "meaning") {
    compare(editor.meaning_at(number(1), number(2)).toStdString(), 2);
  } else if (name == "caret") {
    const QTextCursor caret = editor.textCursor();
    compare(QString("%1:%2")
                .arg(caret.blockNumber() + 1)
                .arg(caret.positionInBlock() + 1)
                .toStdString(),
            0);
  } else if (name == "shown") {
    compare(editor.toPlainText().toStdString(), 0);
  } else {
    workbench::expect(studio_.bench(), words);
  }
}

/// `wait-renders` waits until the queue has no render to run.
void SceneScript::wait_for_renders() {
  constexpr int kMost = 180'000;
  if (!QTest::qWaitFor([this] { return !studio_.runner().busy(); }, kMost))
    throw Error(ErrorCode::bad_input, "the renders did not end within three minutes");
}

bool SceneScript::send_event(const Words& words) {
  QWidget& viewport = window_.viewport();
  const bool on_picture = words.size() > 3 && words[1] == "viewport";
  if (words[0] == "wait-renders")
    wait_for_renders();
  else if (words[0] == "click" && on_picture)
    QTest::mouseClick(&viewport, Qt::LeftButton,
                      words.size() > 4 && words[4] == "ctrl" ? Qt::ControlModifier : Qt::NoModifier,
                      picture_point(viewport, words[2], words[3]));
  else if (words[0] == "click" && words.size() == 3 && words[1] == "symbol")
    click_symbol(viewport, studio_.bench(), words);
  else if (words[0] == "drag" && words.size() > 2 && words[1] == "handle")
    drag_handle_by_mouse(viewport, studio_.bench(), words);
  else if (words[0] == "drag" && on_picture)
    drag_picture(viewport, words);
  else
    return false;
  return true;
}

}  // namespace vug::studio
