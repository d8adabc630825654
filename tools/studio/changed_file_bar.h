// SPDX-License-Identifier: Apache-2.0
// The bar at the top of the window of scenes that reports changes of the file by other programs.
#pragma once

#include "scene_studio.h"

#include <QWidget>

class QLabel;

namespace vug::studio {

/// Hidden while the file is the one that was opened or saved. It offers to take the text of the
/// file, to replace the file, and to decide later: a save then asks again.
class ChangedFileBar : public QWidget {
  Q_OBJECT
 public:
  explicit ChangedFileBar(SceneStudio& studio);

 private:
  void show_lines(const QString& lines);

  SceneStudio& studio_;
  QLabel* text_ = nullptr;
};

}  // namespace vug::studio
