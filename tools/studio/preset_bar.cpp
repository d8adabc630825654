// SPDX-License-Identifier: Apache-2.0
#include "preset_bar.h"

#include "focused_box.h"

#include <vug/workbench/words.h>

#include <QComboBox>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

namespace vug::studio {

PresetBar::PresetBar(SceneStudio& studio) : studio_(studio) {
  auto* lines = new QVBoxLayout(this);
  lines->setContentsMargins(12, 4, 12, 0);
  lines->setSpacing(2);
  list_ = new FocusedBox<QComboBox>;
  list_->setObjectName("presets");
  list_->setAccessibleName(tr("Presets"));
  list_->setToolTip(tr("Sets all parameters to the values of a preset"));
  lines->addWidget(list_);
  auto* line = new QHBoxLayout;
  lines->addLayout(line);
  const auto add = [&](const QString& text, const char* name, const QString& title) {
    QToolButton* button = add_button(text, name, title);
    line->addWidget(button);
    return button;
  };
  connect(add(tr("Save"), "save preset", tr("Keeps the values of all parameters as a preset")),
          &QToolButton::clicked, this, &PresetBar::save);
  lock_ = add(tr("Lock"), "lock preset", tr("Protects the preset from changes"));
  lock_->setCheckable(true);
  connect(lock_, &QToolButton::clicked, this, [this](bool locked) {
    run(locked ? "lock_preset" : "unlock_preset", chosen());
    refresh();
  });
  delete_ = add(tr("Delete"), "delete preset", tr("Deletes the preset"));
  connect(delete_, &QToolButton::clicked, this, [this] {
    run("delete_preset", chosen());
    refresh();
  });
  connect(list_, &QComboBox::activated, this, [this] {
    if (!chosen().isEmpty()) run("preset", chosen());
    refresh();
  });
  connect(&studio_, &SceneStudio::changed, this, &PresetBar::refresh);
}

QToolButton* PresetBar::add_button(const QString& text, const char* name, const QString& title) {
  auto* button = new QToolButton;
  button->setText(text);
  button->setObjectName(name);
  button->setAccessibleName(title);
  button->setToolTip(title);
  button->setFocusPolicy(Qt::StrongFocus);
  return button;
}

QString PresetBar::chosen() const { return list_->currentData().toString(); }

bool PresetBar::run(const char* command, const QString& preset) {
  return studio_.run(std::string(command) + " " + workbench::quoted(preset.toStdString()));
}

void PresetBar::save() {
  bool given = false;
  const QString name = QInputDialog::getText(this, tr("Save preset"), tr("Name"), QLineEdit::Normal,
                                             chosen(), &given);
  if (!given || name.trimmed().isEmpty() || !run("save_preset", name.trimmed())) return;
  refresh();
  list_->setCurrentIndex(list_->findData(name.trimmed()));
  refresh();
}

void PresetBar::refresh() {
  const workbench::SceneBench& bench = studio_.bench();
  const bool open = bench.has_document();
  setEnabled(open);
  const std::vector<workbench::Preset> presets =
      open ? bench.presets().all() : std::vector<workbench::Preset>();
  QStringList rows;
  for (const workbench::Preset& each : presets)
    rows << (each.locked ? tr("%1 (locked)").arg(text_of(each.name)) : text_of(each.name));
  const QString before = chosen();
  if (rows != shown_ || list_->count() == 0) {
    const QSignalBlocker quiet(list_);
    shown_ = rows;
    list_->clear();
    list_->addItem(presets.empty() ? tr("No presets") : tr("Presets"), QString());
    for (size_t i = 0; i < presets.size(); ++i)
      list_->addItem(rows[static_cast<int>(i)], text_of(presets[i].name));
    list_->setCurrentIndex(std::max(0, list_->findData(before)));
  }
  const int index = list_->currentIndex() - 1;
  const bool some = index >= 0 && index < static_cast<int>(presets.size());
  const bool locked = some && presets[static_cast<size_t>(index)].locked;
  lock_->setEnabled(some);
  lock_->setChecked(locked);
  delete_->setEnabled(some && !locked);
}

}  // namespace vug::studio
