// SPDX-License-Identifier: Apache-2.0
#include "theme.h"

#include <vug/base/srgb.h>
#include <vug/workbench/export_facade.h>

#include <QApplication>
#include <QFile>
#include <QPainter>
#include <QStyleFactory>
#include <QSvgRenderer>
#include <algorithm>

namespace vug::studio {
namespace {

Theme light_theme() {
  return {false,
          QColor("#f3f3f1"),
          QColor("#ffffff"),
          QColor("#d9d8d4"),
          QColor("#23262b"),
          QColor("#636870"),
          QColor("#0a66c2"),
          QColor("#ffffff"),
          QColor("#e4e4e1"),
          QColor("#b3261e"),
          QColor("#f28c00"),
          QColor("#0a66c2"),
          QColor("#e5173f"),
          QColor("#ffd84d")};
}

Theme dark_theme() {
  return {true,
          QColor("#1e2024"),
          QColor("#26292e"),
          QColor("#3a3e45"),
          QColor("#e6e7ea"),
          QColor("#a3a8b1"),
          QColor("#5aa9ff"),
          QColor("#10151c"),
          QColor("#16181b"),
          QColor("#ff8a80"),
          QColor("#ffa733"),
          QColor("#5aa9ff"),
          QColor("#ff4d6d"),
          QColor("#ffd84d")};
}

Theme& current() {
  static Theme now = light_theme();
  return now;
}

QPalette palette_of(const Theme& t) {
  QPalette out;
  const auto set = [&](QPalette::ColorRole role, const QColor& colour, const QColor& disabled) {
    out.setColor(role, colour);
    out.setColor(QPalette::Disabled, role, disabled);
  };
  set(QPalette::Window, t.window, t.window);
  set(QPalette::WindowText, t.text, t.muted);
  set(QPalette::Base, t.panel, t.panel);
  set(QPalette::AlternateBase, t.window, t.window);
  set(QPalette::Text, t.text, t.muted);
  set(QPalette::Button, t.panel, t.window);
  set(QPalette::ButtonText, t.text, t.muted);
  set(QPalette::ToolTipBase, t.panel, t.panel);
  set(QPalette::ToolTipText, t.text, t.text);
  set(QPalette::Highlight, t.accent, t.border);
  set(QPalette::HighlightedText, t.on_accent, t.text);
  set(QPalette::Link, t.accent, t.accent);
  set(QPalette::PlaceholderText, t.muted, t.muted);
  set(QPalette::Mid, t.border, t.border);
  set(QPalette::Dark, t.border, t.border);
  return out;
}

const char* kStyleSheet = R"(
QToolTip { color: %text; background: %panel; border: 1px solid %border; padding: 4px; }
QMainWindow::separator, QSplitter::handle { background: %border; }
QSplitter::handle:horizontal { width: 1px; } QSplitter::handle:vertical { height: 1px; }
QTreeView { border: none; background: %panel; outline: none; }
QTreeView::item { padding: 3px 2px; }
QHeaderView::section { background: %panel; color: %muted; border: none; padding: 4px 6px; }
QToolBar { border: none; border-bottom: 1px solid %border; spacing: 2px; padding: 4px 8px; background: %window; }
QToolButton { border: 1px solid transparent; border-radius: 5px; padding: 4px; }
QToolButton:hover, QToolButton:focus { background: %panel; border-color: %border; }
QToolButton:checked { background: %accent; color: %onaccent; }
QStatusBar { border-top: 1px solid %border; color: %muted; } QStatusBar::item { border: none; }
QLineEdit { border: 1px solid %border; border-radius: 5px; padding: 4px 6px; background: %panel; selection-background-color: %accent; }
QLineEdit:focus, QListWidget:focus { border-color: %accent; }
QPushButton { border: 1px solid %border; border-radius: 5px; padding: 5px 14px; background: %panel; }
QPushButton:hover { border-color: %accent; } QPushButton:default, QPushButton:focus { border-color: %accent; }
QPushButton:disabled { color: %muted; background: %window; }
QProgressBar { border: none; border-radius: 3px; background: %border; max-height: 6px; }
QProgressBar::chunk { border-radius: 3px; background: %accent; }
QLabel[role="heading"] { color: %muted; font-weight: 600; }
QLabel[role="value"] { font-size: 15pt; }
QListWidget { border: 1px solid %border; border-radius: 5px; background: %panel; }
)";

/// Whether the palette that the system gives is dark.
bool system_is_dark() {
  static const QPalette system = QApplication::palette();
  return system.color(QPalette::WindowText).lightness() >
         system.color(QPalette::Window).lightness();
}

}  // namespace

const Theme& theme() { return current(); }

void set_theme(QApplication& app, const QString& name) {
  const bool dark = name == "dark" || (name != "light" && system_is_dark());
  current() = dark ? dark_theme() : light_theme();
  const Theme& t = current();
  QApplication::setStyle(QStyleFactory::create("Fusion"));
  QApplication::setPalette(palette_of(t));
  QString sheet = kStyleSheet;
  sheet.replace("%onaccent", t.on_accent.name()).replace("%accent", t.accent.name());
  sheet.replace("%window", t.window.name()).replace("%panel", t.panel.name());
  sheet.replace("%border", t.border.name()).replace("%text", t.text.name());
  sheet.replace("%muted", t.muted.name());
  app.setStyleSheet(sheet);
}

QColor colour_of(const std::string& kind) {
  const workbench::ElementColour c = workbench::element_colour(kind);
  return QColor::fromRgbF(static_cast<float>(srgb_encode(c.r)),
                          static_cast<float>(srgb_encode(c.g)),
                          static_cast<float>(srgb_encode(c.b)));
}

QIcon icon(const QString& name) {
  QFile file(":/icons/" + name + ".svg");
  if (!file.open(QIODevice::ReadOnly)) return {};
  const QByteArray source = file.readAll();
  QIcon out;
  for (const QIcon::Mode mode : {QIcon::Normal, QIcon::Disabled}) {
    QColor colour = theme().text;
    if (mode == QIcon::Disabled) colour.setAlphaF(0.35f);
    QByteArray coloured = source;
    coloured.replace("currentColor", colour.name().toUtf8());
    for (const int size : {20, 40}) {
      QPixmap pixmap(size, size);
      pixmap.fill(Qt::transparent);
      QPainter painter(&pixmap);
      painter.setOpacity(static_cast<double>(colour.alphaF()));
      QSvgRenderer(coloured).render(&painter);
      painter.end();
      pixmap.setDevicePixelRatio(size / 20.0);
      out.addPixmap(pixmap, mode);
    }
  }
  return out;
}

double contrast(const QColor& a, const QColor& b) {
  const auto luminance = [](const QColor& c) {
    return 0.2126 * srgb_decode(c.redF()) + 0.7152 * srgb_decode(c.greenF()) +
           0.0722 * srgb_decode(c.blueF());
  };
  const double x = luminance(a), y = luminance(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

}  // namespace vug::studio
