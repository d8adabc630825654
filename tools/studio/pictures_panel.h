// SPDX-License-Identifier: Apache-2.0
// The kept pictures of a scene as thumbnails, and their comparison.
#pragma once

#include "scene_studio.h"

#include <QListWidget>

class QComboBox;
class QPushButton;

namespace vug::studio {

/// A click shows a picture, the right button makes it the reference.
class PictureList : public QListWidget {
  Q_OBJECT
 public:
  explicit PictureList(SceneStudio& studio);
  /// The number of the current picture; 0: that of the present text.
  int current() const;

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void refresh();
  void run(const char* command, const QListWidgetItem* item);

  SceneStudio& studio_;
  uint64_t shown_ = ~uint64_t{0};
};

class PicturesPanel : public QWidget {
  Q_OBJECT
 public:
  explicit PicturesPanel(SceneStudio& studio);

 private:
  void refresh();

  SceneStudio& studio_;
  PictureList* list_;
  QComboBox* comparison_;
  QPushButton *keep_, *restore_, *forget_;
};

}  // namespace vug::studio
