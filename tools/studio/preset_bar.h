// SPDX-License-Identifier: Apache-2.0
// The presets of a scene: a list that applies them, and buttons that save, lock and delete them.
#pragma once

#include "scene_studio.h"

#include <QWidget>

class QComboBox;
class QToolButton;

namespace vug::studio {

class PresetBar : public QWidget {
  Q_OBJECT
 public:
  explicit PresetBar(SceneStudio& studio);

 private:
  void refresh();
  void save();
  QToolButton* add_button(const QString& text, const char* name, const QString& title);
  /// The chosen preset; empty for none.
  QString chosen() const;
  bool run(const char* command, const QString& preset);

  SceneStudio& studio_;
  QComboBox* list_;
  QToolButton* lock_ = nullptr;
  QToolButton* delete_ = nullptr;
  QStringList shown_;  ///< The rows, so that the file is compared, not the widget.
};

}  // namespace vug::studio
