// SPDX-License-Identifier: Apache-2.0
// Events of scripts that all windows have.
#include "script_runner.h"

#include <vug/base/error.h>
#include <vug/workbench/words.h>

#include <fmt/format.h>
#include <QAbstractSlider>
#include <QApplication>
#include <QCheckBox>
#include <QTest>

namespace vug::studio {
namespace {

using Words = std::vector<std::string>;

/// click WIDGET | double-click WIDGET
void click(const Words& words) {
  require_words(words, 2, "click WIDGET");
  QWidget& widget = find_widget(words[1]);
  // A check box reacts at its box and its text, which may end before the middle.
  const bool box = qobject_cast<const QCheckBox*>(&widget) != nullptr;
  const QPoint at = box ? QPoint(10, widget.height() / 2) : widget.rect().center();
  if (words[0] == "double-click")
    QTest::mouseDClick(&widget, Qt::LeftButton, {}, at);
  else
    QTest::mouseClick(&widget, Qt::LeftButton, {}, at);
}

/// The widget that receives keys: the one with the focus.
QWidget& focused(QWidget& window) {
  if (QWidget* modal = QApplication::activeModalWidget()) {
    QWidget* inside = modal->focusWidget();
    return inside ? *inside : *modal;
  }
  QWidget* widget = window.focusWidget();
  return widget ? *widget : window;
}

void press_keys(QWidget& window, const Words& words) {
  require_words(words, 2, "key Ctrl+Z");
  // Keys of actions need an active window; without a window manager, closing a dialog leaves none.
  if (!QApplication::activeModalWidget() && !window.isActiveWindow()) {
    window.activateWindow();
    static_cast<void>(QTest::qWaitForWindowActive(&window, 1000));
  }
  for (size_t i = 1; i < words.size(); ++i) {
    const QKeySequence keys(QString::fromStdString(words[i]), QKeySequence::PortableText);
    if (keys.isEmpty() || keys[0].key() == Qt::Key_unknown)
      throw Error(ErrorCode::bad_input, fmt::format("unknown key '{}'", words[i]));
    QTest::keyClick(&focused(window), keys[0].key(), keys[0].keyboardModifiers());
  }
}

void hover(const Words& words) {
  require_words(words, 2, "hover WIDGET");
  QWidget& widget = find_widget(words[1]);
  const QPointF at = widget.rect().center();
  QEnterEvent enter(at, widget.mapTo(widget.window(), at), widget.mapToGlobal(at));
  QApplication::sendEvent(&widget, &enter);
}

/// slide WIDGET VALUE...: drags the knob of a slider to each of the values.
void slide(const Words& words) {
  require_words(words, 3, "slide WIDGET VALUE");
  auto* slider = qobject_cast<QAbstractSlider*>(&find_widget(words[1]));
  if (!slider)
    throw Error(ErrorCode::bad_input, fmt::format("'{}' is not a slider", words[1]), {},
                "name a slider");
  slider->setSliderDown(true);
  for (size_t i = 2; i < words.size(); ++i)
    slider->setSliderPosition(static_cast<int>(workbench::parse_number(words[i])));
  slider->setSliderDown(false);
}

}  // namespace

void require_words(const Words& words, size_t least, const char* usage) {
  if (words.size() < least)
    throw Error(ErrorCode::bad_input, fmt::format("wrong number of arguments of {}", words[0]), {},
                usage);
}

bool send_events(QWidget& window, const Words& words) {
  const std::string& name = words[0];
  if (name == "click" || name == "double-click")
    click(words);
  else if (name == "key")
    press_keys(window, words);
  else if (name == "hover")
    hover(words);
  else if (name == "slide")
    slide(words);
  else if (name == "focus" && words.size() == 2)
    find_widget(words[1]).setFocus();
  else if (name == "type" && words.size() == 2)
    QTest::keyClicks(&focused(window), QString::fromStdString(words[1]));
  else
    return false;
  return true;
}

}  // namespace vug::studio
