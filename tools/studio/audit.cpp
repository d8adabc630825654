// SPDX-License-Identifier: Apache-2.0
// Checks of the widgets for users of keyboards and screen readers.
#include "script_runner.h"
#include "theme.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QSet>
#include <QStringList>
#include <map>

namespace vug::studio {
namespace {

/// Widgets inside of others, such as the line of a spin box, have no name of their own.
bool is_part(const QWidget& widget) {
  return widget.objectName().startsWith("qt_") || widget.focusProxy() ||
         widget.focusPolicy() == Qt::NoFocus;
}

void check_names(const QWidget& window, QStringList& out) {
  for (const QWidget* each : window.findChildren<QWidget*>())
    if (!is_part(*each) && each->isVisible() && each->accessibleName().isEmpty())
      out << QString("%1 '%2' has no accessible name")
                 .arg(each->metaObject()->className(), each->objectName());
}

/// The chain of the Tab key returns to its start and contains all widgets that take the focus; each
/// dialog has its own.
void check_tab_order(QWidget& window, QStringList& out) {
  QSet<const QWidget*> chain;
  const QWidget* at = &window;
  for (int steps = 0; steps < 10'000; ++steps) {
    at = at->nextInFocusChain();
    if (at == &window) break;
    chain.insert(at);
  }
  if (at != &window) out << "the tab order does not close";
  for (QWidget* each : window.findChildren<QWidget*>()) {
    if (!each->isVisible()) continue;
    if (each->isWindow())
      check_tab_order(*each, out);
    else if (each->window() == &window && (each->focusPolicy() & Qt::TabFocus) &&
             !chain.contains(each))
      out << QString("'%1' is not in the tab order").arg(each->objectName());
  }
}

void check_keys(const QWidget& window, QStringList& out) {
  std::map<QString, QString> owner;
  for (const QAction* action : window.findChildren<QAction*>())
    for (const QKeySequence& keys : action->shortcuts()) {
      const QString text = keys.toString(QKeySequence::PortableText);
      if (text.isEmpty()) continue;
      const auto [known, added] = owner.emplace(text, action->objectName());
      if (!added)
        out << QString("'%1' and '%2' share the keys %3")
                   .arg(known->second, action->objectName(), text);
    }
}

/// Texts are readable: contrast of 4.5 (WCAG 2.1, AA).
void check_contrast(QStringList& out) {
  const Theme& t = theme();
  for (const auto& [name, text, ground] : {std::tuple("text", t.text, t.panel),
                                           {"text on window", t.text, t.window},
                                           {"muted text", t.muted, t.panel},
                                           {"muted text on window", t.muted, t.window},
                                           {"selected text", t.on_accent, t.accent},
                                           {"errors", t.error, t.window}})
    if (contrast(text, ground) < 4.5)
      out << QString("%1 has a contrast of %2").arg(name).arg(contrast(text, ground), 0, 'f', 2);
}

void check_clipping(const QWidget& window, QStringList& out) {
  for (const QLabel* each : window.findChildren<QLabel*>())
    if (each->isVisible() && each->objectName() != "message" && !each->wordWrap() &&
        each->textFormat() != Qt::RichText &&
        each->fontMetrics().horizontalAdvance(each->text()) > each->width() + 1)
      out << QString("the label '%1' is clipped").arg(each->text());
}

}  // namespace

QString audit(QWidget& window) {
  QStringList out;
  check_names(window, out);
  check_tab_order(window, out);
  check_keys(window, out);
  check_contrast(out);
  check_clipping(window, out);
  return out.join("; ");
}

}  // namespace vug::studio
