// SPDX-License-Identifier: Apache-2.0
// The queue of renders with their progress.
#pragma once

#include "scene_studio.h"

#include <QWidget>
#include <functional>

class QLabel;
class QPushButton;
class QTreeWidget;

namespace vug::studio {

class RendersPanel : public QWidget {
  Q_OBJECT
 public:
  /// `add` asks for a render and adds it.
  RendersPanel(SceneStudio& studio, const std::function<void()>& add);

 private:
  void refresh();
  void refresh_buttons();
  int current() const;
  void run(const char* command);

  SceneStudio& studio_;
  QTreeWidget* list_;
  QLabel* error_;
  QPushButton *add_, *pause_, *resume_, *cancel_;
  uint64_t shown_ = ~uint64_t{0};
};

}  // namespace vug::studio
