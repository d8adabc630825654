// SPDX-License-Identifier: Apache-2.0
// The command palette: a line that runs any command, with a list of those that match.
#pragma once

#include "studio.h"

#include <QDialog>

class QLineEdit;
class QListWidget;

namespace vug::studio {

class CommandPalette : public QDialog {
  Q_OBJECT
 public:
  CommandPalette(Studio& studio, QWidget* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void filter();
  void run();

  Studio& studio_;
  QLineEdit* line_;
  QListWidget* list_;
};

}  // namespace vug::studio
