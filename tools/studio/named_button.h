// SPDX-License-Identifier: Apache-2.0
// Push buttons with the names that scripts and screen readers use.
#pragma once

#include <QPushButton>

namespace vug::studio {

inline QPushButton* named_button(const QString& title, const char* name) {
  auto* button = new QPushButton(title);
  button->setObjectName(name);
  button->setAccessibleName(title);
  return button;
}

}  // namespace vug::studio
