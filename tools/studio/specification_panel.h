// SPDX-License-Identifier: Apache-2.0
// The form at the bottom, generated from the free numbers of the selected node.
#pragma once

#include "studio.h"

#include <vug/workbench/specification.h>

#include <QWidget>
#include <vector>

class QAbstractSpinBox;
class QComboBox;
class QGridLayout;
class QLabel;

namespace vug::studio {

class SpecificationPanel : public QWidget {
  Q_OBJECT
 public:
  explicit SpecificationPanel(Studio& studio);

 protected:
  void resizeEvent(QResizeEvent*) override;

 private:
  void refresh();
  void rebuild();
  void place();
  void refresh_rules();
  void edited(size_t index, double value);

  Studio& studio_;
  QLabel* title_;
  std::vector<QLabel*> rule_labels_;
  QWidget* body_;
  QGridLayout* grid_;
  workbench::Specification form_;
  struct Entry {
    QLabel* label;
    QAbstractSpinBox* box;
  };
  std::vector<Entry> entries_;
  std::vector<workbench::RuleField> rules_;
  std::vector<QComboBox*> rule_boxes_;  ///< As many as ever needed; the others are hidden.
  bool updating_ = false;
};

}  // namespace vug::studio
