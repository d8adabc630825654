// SPDX-License-Identifier: Apache-2.0
#include "recovery_bar.h"

#include "named_button.h"

#include <QHBoxLayout>
#include <QLabel>

namespace vug::studio {

void fill_recovery_bar(QWidget& bar, const workbench::LostJournal& lost,
                       const std::function<bool()>& recover) {
  auto* line = new QHBoxLayout(&bar);
  line->setContentsMargins(14, 8, 14, 8);
  line->addWidget(
      new QLabel(QObject::tr("Vug Studio ended with unsaved edits: %n step(s) can be recovered.",
                             nullptr, static_cast<int>(lost.lines.size()) - 1)),
      1);
  const auto add = [&](const QString& title, const char* name, const std::function<bool()>& run) {
    QPushButton* const button = named_button(title, name);
    QObject::connect(button, &QPushButton::clicked, &bar, [&bar, run] {
      if (run()) bar.hide();
    });
    line->addWidget(button);
  };
  add(QObject::tr("Recover"), "recover", recover);
  add(QObject::tr("Discard"), "discard", [file = lost.file] {
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
    return true;
  });
  bar.show();
}

}  // namespace vug::studio
