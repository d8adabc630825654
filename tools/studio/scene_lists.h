// SPDX-License-Identifier: Apache-2.0
// The list of the problems of a scene text, and its outline. A click goes to the place in the text.
#pragma once

#include "scene_studio.h"

#include <QListWidget>
#include <QTreeWidget>

namespace vug::studio {

class ProblemList : public QListWidget {
  Q_OBJECT
 public:
  explicit ProblemList(SceneStudio& studio);

 private:
  void refresh();
  SceneStudio& studio_;
  std::shared_ptr<const Diagnostics> shown_;
};

class OutlineTree : public QTreeWidget {
  Q_OBJECT
 public:
  explicit OutlineTree(SceneStudio& studio);

 private:
  void refresh();
  SceneStudio& studio_;
  QStringList shown_;  ///< The rows, so that an unchanged outline keeps its state.
};

}  // namespace vug::studio
