// SPDX-License-Identifier: Apache-2.0
// The line below the picture of a scene: pause, exposure and view transform, and the values of the
// inspected pixel.
#pragma once

#include "scene_studio.h"

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QToolButton;

namespace vug::studio {

class LookBar : public QWidget {
  Q_OBJECT
 public:
  explicit LookBar(SceneStudio& studio);

 private:
  void refresh();

  SceneStudio& studio_;
  QToolButton* pause_;
  QDoubleSpinBox* exposure_;
  QComboBox* tone_;
  QLabel* pixel_;
};

}  // namespace vug::studio
