// SPDX-License-Identifier: Apache-2.0
// The scores of the tree and of compared sessions, and the fit with its stop button.
#pragma once

#include "studio.h"

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace vug::studio {

class ScorePanel : public QWidget {
  Q_OBJECT
 public:
  explicit ScorePanel(Studio& studio);

 private:
  void refresh();
  void show_fit();
  QString comparison_text() const;

  Studio& studio_;
  QLabel *score_, *complexity_, *differing_, *comparisons_, *stage_;
  QPushButton* fit_;
  QProgressBar* progress_;
  std::pair<const void*, size_t> compared_;  ///< Scorer and number of comparisons shown.
};

}  // namespace vug::studio
