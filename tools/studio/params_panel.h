// SPDX-License-Identifier: Apache-2.0
// The parameters of a scene text as sliders and fields, which write into the text.
#pragma once

#include "scene_studio.h"

#include <QScrollArea>
#include <optional>
#include <vector>

class QLabel;
class QLineEdit;
class QToolButton;
class QSlider;
class QVBoxLayout;

namespace vug::studio {

class ParamsPanel : public QScrollArea {
  Q_OBJECT
 public:
  explicit ParamsPanel(SceneStudio& studio);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Row {
    std::string name, range;
    QLabel* label = nullptr;
    QSlider* slider = nullptr;  ///< Null without a range of numbers.
    QLineEdit* field = nullptr;
    QToolButton* reset = nullptr;
  };
  void refresh();
  void rebuild(const std::vector<language::ParamSetting>& params);
  Row add_row(const language::ParamSetting& param);
  void show_changed(const Row& row, const std::optional<std::string>& saved, const QString& text);
  void slide(const std::string& name, int value);
  /// Null if the text does not declare it.
  const language::ParamSetting* find(const std::string& name) const;

  SceneStudio& studio_;
  QVBoxLayout* column_;
  std::vector<Row> rows_;
};

}  // namespace vug::studio
