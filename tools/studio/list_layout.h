// SPDX-License-Identifier: Apache-2.0
// The layout of a tab with a list: a row of buttons above it.
#pragma once

#include <QBoxLayout>

namespace vug::studio {

struct ListLayout {
  QVBoxLayout* column;
  QHBoxLayout* buttons;  ///< The first row of the column.
};

inline ListLayout list_layout(QWidget* panel) {
  auto* column = new QVBoxLayout(panel);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  auto* buttons = new QHBoxLayout;
  buttons->setContentsMargins(8, 4, 8, 0);
  column->addLayout(buttons);
  return {column, buttons};
}

}  // namespace vug::studio
