// SPDX-License-Identifier: Apache-2.0
// Fields whose values the mouse wheel changes only if they have the focus, so that scrolling never
// changes values by chance.
#pragma once

#include <QWheelEvent>

namespace vug::studio {

/// Box: QSpinBox, QDoubleSpinBox or QComboBox.
template <class Box>
class FocusedBox : public Box {
 public:
  using Box::Box;

 protected:
  void wheelEvent(QWheelEvent* event) override {
    if (this->hasFocus())
      Box::wheelEvent(event);
    else
      event->ignore();
  }
};

}  // namespace vug::studio
