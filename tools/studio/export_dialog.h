// SPDX-License-Identifier: Apache-2.0
// The export dialog: all files of a facade, written together.
#pragma once

#include "studio.h"

#include <QDialog>
#include <vector>

class QCheckBox;
class QLineEdit;

namespace vug::studio {

class ExportDialog : public QDialog {
  Q_OBJECT
 public:
  ExportDialog(Studio& studio, QWidget* parent);

 private:
  void write();

  Studio& studio_;
  QLineEdit *folder_, *name_;
  std::vector<QCheckBox*> kinds_;
};

}  // namespace vug::studio
