// SPDX-License-Identifier: Apache-2.0
// The command palette: a line that runs any command, with a list of those that match.
#pragma once

#include "studio.h"

#include <vug/workbench/command.h>

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
  void add(const workbench::Command& command);
  /// 0 to 2 for a command that matches, the best first; 3 for another one.
  static int rank_of(const workbench::Command& command, const QString& wanted);
  void run();

  Studio& studio_;
  QLineEdit* line_;
  QListWidget* list_;
};

}  // namespace vug::studio
