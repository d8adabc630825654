// SPDX-License-Identifier: Apache-2.0
#include "export_dialog.h"

#include <vug/workbench/export_facade.h>
#include <vug/workbench/words.h>

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace vug::studio {

ExportDialog::ExportDialog(Studio& studio, QWidget* parent) : QDialog(parent), studio_(studio) {
  setObjectName("export dialog");
  setWindowTitle(tr("Export facade"));
  setAccessibleName(windowTitle());
  setMinimumWidth(460);
  auto* column = new QVBoxLayout(this);
  column->setSpacing(10);
  auto* form = new QFormLayout;
  folder_ = new QLineEdit(text_of(studio.bench().folder().string()));
  folder_->setObjectName("export folder");
  folder_->setAccessibleName(tr("Folder"));
  const auto& named =
      studio.bench().file().empty() ? studio.bench().photo() : studio.bench().file();
  name_ = new QLineEdit(text_of(named.stem().string() + "_export"));
  name_->setObjectName("export name");
  name_->setAccessibleName(tr("Name"));
  form->addRow(tr("Folder"), folder_);
  form->addRow(tr("Name"), name_);
  column->addLayout(form);
  for (const workbench::ExportKind& each : workbench::export_kinds()) {
    auto* box = new QCheckBox(QString("%1: %2").arg(text_of(each.name), text_of(each.doc)));
    box->setObjectName("export " + text_of(each.name));
    box->setAccessibleName(box->text());
    box->setChecked(each.name == "svg" || each.name == "json");
    column->addWidget(box);
    kinds_.push_back(box);
  }
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  auto* write_button = buttons->addButton(tr("Export"), QDialogButtonBox::AcceptRole);
  write_button->setObjectName("export files");
  write_button->setDefault(true);
  for (QAbstractButton* each : buttons->buttons()) each->setAccessibleName(each->text());
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &ExportDialog::write);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void ExportDialog::write() {
  const std::filesystem::path folder = folder_->text().toStdString();
  const auto& all = workbench::export_kinds();
  for (size_t i = 0; i < all.size(); ++i) {
    if (!kinds_[i]->isChecked()) continue;
    // Kinds of one extension have different names.
    const std::string suffix = all[i].name == "carve"     ? "_carved"
                               : all[i].name == "session" ? "_session"
                                                          : "";
    const std::filesystem::path file =
        folder / (name_->text().toStdString() + suffix + all[i].extension);
    if (!studio_.run("export " + all[i].name + " " + workbench::quoted(file.string()))) return;
  }
  Q_EMIT studio_.message(tr("The files are in %1.").arg(folder_->text()), false);
  accept();
}

}  // namespace vug::studio
