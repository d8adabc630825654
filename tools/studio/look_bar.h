// SPDX-License-Identifier: Apache-2.0
// The lines below the picture of a scene: pause, exposure, view transform, denoising and layer, and
// the values of the inspected pixel.
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
  QToolButton* denoise_;
  QComboBox* layer_;
  QStringList layers_;
  QLabel* pixel_;
};

}  // namespace vug::studio
