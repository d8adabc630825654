// SPDX-License-Identifier: Apache-2.0
#include "prompts.h"

#include "export_dialog.h"

#include <vug/workbench/words.h>

#include <QFileDialog>
#include <QInputDialog>

namespace vug::studio {
namespace {

std::string file_line(const std::string& command, const QString& file) {
  return file.isEmpty() ? "" : command + " " + workbench::quoted(file.toStdString());
}

/// The folder of the document, in which dialogs begin.
QString folder_of(const Studio& studio) {
  return studio.bench().has_document() ? text_of(studio.bench().folder().string()) : QString();
}

std::string photo_line(QWidget& parent, const Studio& studio) {
  const QString file =
      QFileDialog::getOpenFileName(&parent, QObject::tr("Open photo"), folder_of(studio),
                                   QObject::tr("Pictures (*.jpg *.jpeg *.png *.tif *.tiff *.exr)"));
  if (file.isEmpty()) return "";
  bool given = false;
  const QString width =
      QInputDialog::getText(&parent, QObject::tr("Width of the facade"),
                            QObject::tr("Width in metres; Ctrl+L measures it later by two clicks"),
                            QLineEdit::Normal, "12m", &given);
  return given ? file_line("photo", file) + " " + workbench::quoted(width.toStdString()) : "";
}

}  // namespace

std::string save_as_line(QWidget& parent, Studio& studio) {
  return file_line("save", QFileDialog::getSaveFileName(&parent, QObject::tr("Save session"),
                                                        folder_of(studio) + "/facade.json",
                                                        QObject::tr("Sessions (*.json)")));
}

std::string prompt(QWidget& parent, Studio& studio, const std::string& command) {
  if (command == "photo") return photo_line(parent, studio);
  if (command == "open" || command == "compare")
    return file_line(
        command, QFileDialog::getOpenFileName(&parent, QObject::tr("Open session"),
                                              folder_of(studio), QObject::tr("Sessions (*.json)")));
  if (command == "save")
    return studio.bench().file().empty() ? save_as_line(parent, studio) : "save";
  if (command == "export") {
    auto* dialog = new ExportDialog(studio, &parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
    return "";
  }
  bool given = false;
  const QString name = QInputDialog::getText(&parent, QObject::tr("Checkpoint"),
                                             QObject::tr("Name"), QLineEdit::Normal, "", &given);
  return given ? command + " " + workbench::quoted(name.toStdString()) : "";
}

}  // namespace vug::studio
