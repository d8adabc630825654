// SPDX-License-Identifier: Apache-2.0
// The derivation tree, which grows with each action; its selection is that of the canvas.
#pragma once

#include "studio.h"

#include <QWidget>
#include <set>
#include <vector>

class QTreeWidget;
class QTreeWidgetItem;

namespace vug::studio {

class TreePanel : public QWidget {
  Q_OBJECT
 public:
  explicit TreePanel(Studio& studio);

 private:
  void refresh();
  void rebuild();
  void selected_by_user();

  Studio& studio_;
  QTreeWidget* tree_;
  std::vector<QTreeWidgetItem*> items_;  ///< Indexed like the nodes of the tree.
  std::set<QString> folded_;             ///< Paths that the user has folded.
  uint64_t shown_ = 0;
  bool updating_ = false;
};

}  // namespace vug::studio
