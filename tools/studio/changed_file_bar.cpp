// SPDX-License-Identifier: Apache-2.0
#include "changed_file_bar.h"

#include "named_button.h"

#include <QHBoxLayout>
#include <QLabel>

namespace vug::studio {

ChangedFileBar::ChangedFileBar(SceneStudio& studio) : studio_(studio) {
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(14, 8, 14, 8);
  text_ = new QLabel;
  text_->setObjectName("changed_file");
  text_->setAccessibleName(tr("Change of the file"));
  text_->setWordWrap(true);
  line->addWidget(text_, 1);
  const auto add = [&](const QString& title, const char* name, const QString& help,
                       const std::function<void()>& run) {
    QPushButton* const button = named_button(title, name);
    button->setToolTip(help);
    connect(button, &QPushButton::clicked, this, run);
    line->addWidget(button);
  };
  add(tr("Reload"), "reload_file", tr("Takes the text of the file; undo returns to yours"),
      [this] { studio_.run("reload"); });
  add(tr("Overwrite"), "overwrite_file", tr("Replaces the text of the file by yours"),
      [this] { studio_.run("overwrite"); });
  add(tr("Later"), "later", tr("Changes nothing; a save asks again"), [this] { hide(); });
  connect(&studio_, &SceneStudio::file_changed, this, &ChangedFileBar::show_lines);
  hide();
}

void ChangedFileBar::show_lines(const QString& lines) {
  text_->setText(tr("Another program has changed %1 of the file.").arg(lines));
  setVisible(!lines.isEmpty());
}

}  // namespace vug::studio
