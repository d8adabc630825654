// SPDX-License-Identifier: Apache-2.0
// Colours and icons of the window for the light and the dark theme.
#pragma once

#include <QColor>
#include <QIcon>
#include <QPalette>
#include <QString>

class QApplication;

namespace vug::studio {

struct Theme {
  bool dark = false;
  QColor window, panel, border, text, muted, accent, on_accent, canvas, error;
  QColor open, ghost, difference, line;  ///< On the canvas, where a photo is below them.
};

/// The theme of the program; by default that of the system.
const Theme& theme();
/// "system", "light" or "dark"; sets the palette and the style of the program.
void set_theme(QApplication& app, const QString& name);

/// The colour of a kind of element on the canvas.
QColor colour_of(const std::string& kind);

/// An icon of the resources in the colour of the text.
QIcon icon(const QString& name);
/// A pictogram of an action, such as "rows(FacadeRow, PartFacade)" or "RegularGrid".
QIcon action_icon(const QString& action, bool available);

/// Contrast ratio of two colours (WCAG 2.1), 1 to 21.
double contrast(const QColor& a, const QColor& b);

}  // namespace vug::studio
