// SPDX-License-Identifier: Apache-2.0
#include "params_panel.h"

#include "studio.h"

#include <vug/workbench/words.h>

#include <fmt/format.h>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>

namespace vug::studio {
namespace {

/// Whole numbers have one step each, up to this number.
constexpr double kMostWholeSteps = 1000;

int steps_of(const language::ParamSetting& param) {
  const double width = param.high.get<Number>()->value - param.low.get<Number>()->value;
  return param.whole && width <= kMostWholeSteps ? static_cast<int>(width) : language::kSliderSteps;
}

}  // namespace

ParamsPanel::ParamsPanel(SceneStudio& studio) : studio_(studio) {
  setObjectName("parameters");
  setAccessibleName(tr("Parameters"));
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::NoFocus);
  auto* inside = new QWidget;
  column_ = new QVBoxLayout(inside);
  column_->setContentsMargins(12, 8, 12, 8);
  column_->setAlignment(Qt::AlignTop);
  setWidget(inside);
  connect(&studio_, &SceneStudio::analysed, this, &ParamsPanel::refresh);
}

void ParamsPanel::refresh() {
  if (!studio_.bench().has_document()) return;
  const std::vector<language::ParamSetting>& params = studio_.bench().params();
  const bool same = std::equal(rows_.begin(), rows_.end(), params.begin(), params.end(),
                               [](const Row& row, const language::ParamSetting& param) {
                                 return row.name == param.name && row.range == param.range &&
                                        (row.slider != nullptr) == param.has_slider();
                               });
  if (!same) rebuild(params);
  for (size_t i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    if (row.slider && !row.slider->isSliderDown()) {
      const QSignalBlocker quiet(row.slider);
      row.slider->setValue(
          static_cast<int>(std::lround(params[i].fraction() * row.slider->maximum())));
    }
    const QString text = text_of(params[i].text);
    if (row.field->text() != text) row.field->setText(text);
    show_changed(row, studio_.bench().saved_param(row.name), text);
  }
}

void ParamsPanel::rebuild(const std::vector<language::ParamSetting>& params) {
  // The old widgets may be sending the signal that leads here.
  while (QLayoutItem* item = column_->takeAt(0)) {
    if (item->widget()) {
      item->widget()->hide();
      item->widget()->deleteLater();
    }
    delete item;
  }
  rows_.clear();
  if (params.empty()) {
    auto* none =
        new QLabel(tr("The text has no parameters, such as\nparam SIZE = 30cm in 1cm..3m"));
    none->setWordWrap(true);
    column_->addWidget(none);
  }
  for (const language::ParamSetting& each : params) rows_.push_back(add_row(each));
}

ParamsPanel::Row ParamsPanel::add_row(const language::ParamSetting& param) {
  Row row{param.name, param.range};
  const QString name = text_of(param.name);
  auto* box = new QWidget;
  auto* lines = new QVBoxLayout(box);
  lines->setContentsMargins(0, 0, 0, 6);
  lines->setSpacing(2);
  auto* first = new QHBoxLayout;
  row.label = new QLabel(name);
  row.field = new QLineEdit;
  row.field->setObjectName("value " + name);
  row.field->setAccessibleName(tr("Value of %1").arg(name));
  row.field->setMaximumWidth(130);
  const QString doc = text_of(param.doc + (param.range.empty() ? "" : " (" + param.range + ")"));
  for (QWidget* each : {static_cast<QWidget*>(row.label), static_cast<QWidget*>(row.field)})
    each->setToolTip(doc);
  first->addWidget(row.label, 1);
  first->addWidget(row.field);
  row.reset = new QToolButton;
  row.reset->setObjectName("reset " + name);
  row.reset->setAccessibleName(tr("Reset %1").arg(name));
  row.reset->setText(QStringLiteral("\u21ba"));
  row.reset->setFocusPolicy(Qt::StrongFocus);
  first->addWidget(row.reset);
  connect(row.reset, &QToolButton::clicked, this,
          [this, own = param.name] { studio_.run("reset " + own); });
  lines->addLayout(first);
  connect(row.field, &QLineEdit::editingFinished, this,
          [this, field = row.field, own = param.name] {
            const std::string value = field->text().trimmed().toStdString();
            // A field that vanishes with its param loses the focus, too.
            const language::ParamSetting* present = find(own);
            if (!present || value.empty() || value == present->text) return;
            studio_.run(fmt::format("param {} {}", own, workbench::quoted(value)));
          });
  if (param.has_slider()) {
    row.slider = new QSlider(Qt::Horizontal);
    row.slider->setObjectName("slider " + name);
    row.slider->setAccessibleName(name);
    row.slider->setToolTip(doc);
    row.slider->setRange(0, steps_of(param));
    row.slider->setFocusPolicy(Qt::StrongFocus);
    row.slider->installEventFilter(this);
    lines->addWidget(row.slider);
    connect(row.slider, &QSlider::valueChanged, this,
            [this, own = param.name](int value) { slide(own, value); });
    connect(row.slider, &QSlider::sliderReleased, this, [this] { studio_.run("end_step"); });
  }
  column_->addWidget(box);
  return row;
}

/// Values that differ from the saved text are bold and can be reset.
void ParamsPanel::show_changed(const Row& row, const std::optional<std::string>& saved,
                               const QString& text) {
  const bool changed = saved && text_of(*saved) != text;
  for (QWidget* each : {static_cast<QWidget*>(row.label), static_cast<QWidget*>(row.field)}) {
    QFont font = each->font();
    font.setBold(changed);
    each->setFont(font);
  }
  row.label->setProperty("changed", changed ? "yes" : "no");
  row.reset->setEnabled(changed);
  row.reset->setToolTip(changed
                            ? tr("Restores %1, the value of the saved text").arg(text_of(*saved))
                            : tr("The value is that of the saved text"));
}

const language::ParamSetting* ParamsPanel::find(const std::string& name) const {
  for (const language::ParamSetting& each : studio_.bench().params())
    if (each.name == name) return &each;
  return nullptr;
}

void ParamsPanel::slide(const std::string& name, int value) {
  const language::ParamSetting* param = find(name);
  if (!param || !param->has_slider()) return;
  const std::string text =
      language::slider_text(*param, static_cast<double>(value) / steps_of(*param));
  if (text != param->text)
    studio_.run(fmt::format("param {} {} {}", name, workbench::quoted(text),
                            workbench::quoted("drag " + name)));
}

/// The wheel scrolls the panel unless a slider has the focus: it must not change values by chance.
bool ParamsPanel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Wheel && !static_cast<QWidget*>(watched)->hasFocus()) {
    event->ignore();
    return true;
  }
  return QScrollArea::eventFilter(watched, event);
}

}  // namespace vug::studio
