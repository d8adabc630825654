// SPDX-License-Identifier: Apache-2.0
#include "command_palette.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QVBoxLayout>

namespace vug::studio {

CommandPalette::CommandPalette(std::vector<PaletteEntry> entries,
                               std::function<bool(const std::string&)> run, const QString& example,
                               QWidget* parent)
    : QDialog(parent), entries_(std::move(entries)), run_(std::move(run)) {
  setObjectName("palette dialog");
  setWindowTitle(tr("Commands"));
  setAccessibleName(windowTitle());
  resize(560, 380);
  auto* column = new QVBoxLayout(this);
  line_ = new QLineEdit;
  line_->setObjectName("palette line");
  line_->setAccessibleName(tr("Command"));
  line_->setPlaceholderText(tr("Command, e.g. %1").arg(example));
  list_ = new QListWidget;
  list_->setObjectName("palette list");
  list_->setAccessibleName(tr("Matching commands"));
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setTextElideMode(Qt::ElideRight);
  list_->setSpacing(2);
  column->addWidget(line_);
  column->addWidget(list_);
  line_->installEventFilter(this);
  connect(line_, &QLineEdit::textChanged, this, &CommandPalette::filter);
  connect(line_, &QLineEdit::returnPressed, this, &CommandPalette::run);
  connect(list_, &QListWidget::itemActivated, this, &CommandPalette::run);
  filter();
}

void CommandPalette::filter() {
  list_->clear();
  const QString wanted = line_->text().section(' ', 0, 0).toLower();
  // Names that begin with the word, then other names, then descriptions.
  for (int rank = 0; rank < 3; ++rank)
    for (const PaletteEntry& each : entries_)
      if (rank_of(each, wanted) == rank) add(each);
  list_->setCurrentRow(0);
}

int CommandPalette::rank_of(const PaletteEntry& command, const QString& wanted) {
  const QString name = QString::fromStdString(command.name);
  if (name.startsWith(wanted)) return 0;
  if (name.contains(wanted)) return 1;
  return QString::fromStdString(command.doc).toLower().contains(wanted) ? 2 : 3;
}

void CommandPalette::add(const PaletteEntry& entry) {
  const auto text_of = [](const std::string& text) { return QString::fromStdString(text); };
  const std::string& why = entry.unavailable;
  auto* item = new QListWidgetItem(QString("%1 %2    %3")
                                       .arg(text_of(entry.name), text_of(entry.arguments),
                                            text_of(why.empty() ? entry.doc : why)));
  item->setData(Qt::UserRole, text_of(entry.name));
  item->setData(Qt::UserRole + 1, entry.asks);
  if (!why.empty()) item->setForeground(palette().color(QPalette::Disabled, QPalette::Text));
  item->setToolTip(text_of(entry.doc + (entry.keys.empty() ? "" : " " + entry.keys)));
  list_->addItem(item);
}

/// Runs the line; the name of a command without its arguments is completed first.
void CommandPalette::run() {
  const QString text = line_->text().trimmed();
  const QListWidgetItem* chosen = list_->currentItem();
  if (chosen && !text.contains(' ') && text != chosen->data(Qt::UserRole).toString()) {
    line_->setText(chosen->data(Qt::UserRole).toString() +
                   (chosen->data(Qt::UserRole + 1).toBool() ? " " : ""));
    line_->setFocus();
    if (chosen->data(Qt::UserRole + 1).toBool()) return;
  }
  if (run_(line_->text().toStdString())) accept();
}

/// The arrow keys move through the list while the line has the focus.
bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    const int step = key == Qt::Key_Down ? 1 : key == Qt::Key_Up ? -1 : 0;
    if (step != 0) {
      list_->setCurrentRow(std::clamp(list_->currentRow() + step, 0, list_->count() - 1));
      return true;
    }
  }
  return QDialog::eventFilter(watched, event);
}

}  // namespace vug::studio
