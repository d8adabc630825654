// SPDX-License-Identifier: Apache-2.0
// One button for each action of the grammar. Buttons that are not available give the reason.
#pragma once

#include "studio.h"

#include <QWidget>
#include <vector>

class QAbstractButton;
class QVBoxLayout;

namespace vug::studio {

class ActionPanel : public QWidget {
  Q_OBJECT
 public:
  explicit ActionPanel(Studio& studio);

  /// Performs an action on the selected node, or shows why it is not available.
  void perform(int index);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void rebuild();
  void refresh();
  int index_of(const QObject* button) const;

  Studio& studio_;
  QVBoxLayout* list_;
  std::vector<QAbstractButton*> buttons_;
  std::optional<std::pair<uint64_t, int>> shown_;  ///< Revision and selection.
};

}  // namespace vug::studio
