// SPDX-License-Identifier: Apache-2.0
#include "specification_panel.h"

#include "focused_box.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>

namespace vug::studio {
namespace {

constexpr int kFieldWidth = 106;  // pixels

bool same_fields(const workbench::Specification& a, const workbench::Specification& b) {
  return a.node == b.node && std::equal(a.fields.begin(), a.fields.end(), b.fields.begin(),
                                        b.fields.end(), [](const auto& x, const auto& y) {
                                          return x.label == y.label && x.whole == y.whole;
                                        });
}

}  // namespace

SpecificationPanel::SpecificationPanel(Studio& studio) : studio_(studio) {
  setObjectName("form");
  setAccessibleName(tr("Specification"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(14, 10, 10, 8);
  column->setSpacing(6);
  title_ = new QLabel(tr("Specification"));
  title_->setProperty("role", "heading");
  column->addWidget(title_);
  auto* line = new QHBoxLayout;
  for (const char* name : {"rule 1", "rule 2"}) {
    auto* box = new QComboBox;
    box->setObjectName(name);
    box->setFocusPolicy(Qt::StrongFocus);
    box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    box->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
    auto* label = new QLabel;
    label->setBuddy(box);
    line->addWidget(label);
    line->addWidget(box);
    line->addSpacing(4);
    label->hide(), box->hide();
    const size_t at = rule_boxes_.size();
    connect(box, &QComboBox::activated, this, [this, at](int rule) {
      if (at < rules_.size() && rule >= 0 && rule != rules_[at].current)
        studio_.run(
            workbench::rule_edit(studio_.bench().state(), rules_[at], static_cast<size_t>(rule)));
    });
    rule_labels_.push_back(label);
    rule_boxes_.push_back(box);
  }
  line->addStretch();
  column->addLayout(line);
  auto* scroll = new QScrollArea;
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setAccessibleName(tr("Fields"));
  body_ = new QWidget;
  grid_ = new QGridLayout(body_);
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(10);
  grid_->setVerticalSpacing(3);
  grid_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  scroll->setWidget(body_);
  column->addWidget(scroll);
  connect(&studio_, &Studio::changed, this, &SpecificationPanel::refresh);
}

void SpecificationPanel::refresh() {
  if (!studio_.bench().has_document()) return;
  const workbench::Specification now =
      workbench::specification(studio_.bench().state(), studio_.bench().selected());
  const bool same = same_fields(form_, now);
  form_ = now;
  updating_ = true;
  refresh_rules();
  if (!same) rebuild();
  title_->setText(form_.fields.empty() ? tr("Specification: the selected part has no free numbers")
                                       : tr("Specification: %1").arg(text_of(form_.title)));
  for (size_t i = 0; i < form_.fields.size(); ++i) {
    const workbench::Field& field = form_.fields[i];
    if (auto* box = qobject_cast<QSpinBox*>(entries_[i].box)) {
      box->setRange(static_cast<int>(field.least), static_cast<int>(field.most));
      box->setValue(static_cast<int>(field.value));
    } else if (auto* length = qobject_cast<QDoubleSpinBox*>(entries_[i].box)) {
      length->setRange(field.least, field.most);
      length->setValue(field.value);
    }
    QFont font = entries_[i].box->font();
    font.setBold(field.fixed);
    entries_[i].box->setFont(font);
  }
  updating_ = false;
}

void SpecificationPanel::refresh_rules() {
  rules_ = workbench::rule_fields(studio_.bench().state(), studio_.bench().selected());
  for (size_t i = 0; i < rule_boxes_.size(); ++i) {
    QComboBox& box = *rule_boxes_[i];
    const bool shown = i < rules_.size();
    rule_labels_[i]->setVisible(shown), box.setVisible(shown);
    if (!shown) continue;
    QStringList names;
    for (const std::string& rule : rules_[i].rules) names << text_of(rule);
    QStringList now;
    for (int k = 0; k < box.count(); ++k) now << box.itemText(k);
    if (names != now) {
      box.clear();
      box.addItems(names);
    }
    box.setCurrentIndex(rules_[i].current);
    box.setPlaceholderText(tr("choose a rule"));
    rule_labels_[i]->setText(text_of(rules_[i].symbol));
    box.setAccessibleName(tr("Rule of %1").arg(text_of(rules_[i].symbol)));
  }
}

void SpecificationPanel::rebuild() {
  for (const Entry& each : entries_) {
    each.label->hide(), each.box->hide();
    each.label->deleteLater(), each.box->deleteLater();
  }
  entries_.clear();
  for (size_t i = 0; i < form_.fields.size(); ++i) {
    const workbench::Field& field = form_.fields[i];
    QAbstractSpinBox* box = nullptr;
    if (field.whole) {
      auto* count = new FocusedBox<QSpinBox>(body_);
      connect(count, &QSpinBox::valueChanged, this, [this, i](int value) { edited(i, value); });
      box = count;
    } else {
      auto* length = new FocusedBox<QDoubleSpinBox>(body_);
      length->setDecimals(3);
      length->setSingleStep(0.05);
      length->setSuffix(tr(" m"));
      connect(length, &QDoubleSpinBox::valueChanged, this,
              [this, i](double value) { edited(i, value); });
      box = length;
    }
    box->setKeyboardTracking(false);
    box->setFocusPolicy(Qt::StrongFocus);
    box->setFixedWidth(kFieldWidth);
    box->setObjectName("field " + text_of(field.label));
    box->setAccessibleName(text_of(field.label));
    const QString range =
        field.whole ? tr("%1: a count from %2 to %3") : tr("%1: metres, %2 to %3");
    box->setToolTip(
        range.arg(text_of(field.label)).arg(field.least, 0, 'g', 4).arg(field.most, 0, 'g', 4));
    auto* label = new QLabel(text_of(field.label), body_);
    label->setBuddy(box);
    entries_.push_back({label, box});
    label->show(), box->show();
  }
  place();
}

/// Fills rows of fields, as many as fit, each below its label.
void SpecificationPanel::place() {
  const int columns = std::max(1, (width() - 24) / (kFieldWidth + 10));
  for (size_t i = 0; i < entries_.size(); ++i) {
    const int at = static_cast<int>(i), row = at / columns * 2, column = at % columns;
    grid_->addWidget(entries_[i].label, row, column);
    grid_->addWidget(entries_[i].box, row + 1, column);
  }
  QWidget* before = nullptr;
  for (const Entry& each : entries_) {
    if (before) setTabOrder(before, each.box);
    before = each.box;
  }
}

void SpecificationPanel::resizeEvent(QResizeEvent*) { place(); }

void SpecificationPanel::edited(size_t index, double value) {
  if (updating_ || index >= form_.fields.size()) return;
  modeller::Edit edit =
      workbench::field_edit(studio_.bench().state(), form_, form_.fields[index], value);
  // Steps of one field are one step of the history.
  edit.kind = "adjust";
  studio_.run(edit);
}

}  // namespace vug::studio
