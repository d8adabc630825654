// SPDX-License-Identifier: Apache-2.0
#include "scene_lists.h"

#include "studio.h"
#include "theme.h"

#include <vug/language/outline.h>

#include <fmt/format.h>
#include <QHeaderView>
#include <functional>

namespace vug::studio {
namespace {

constexpr int kLine = Qt::UserRole, kColumn = Qt::UserRole + 1, kFile = Qt::UserRole + 2;

}  // namespace

ProblemList::ProblemList(SceneStudio& studio) : studio_(studio) {
  setObjectName("problems");
  setAccessibleName(tr("Problems"));
  setWordWrap(true);
  connect(&studio_, &SceneStudio::news, this, &ProblemList::refresh);
  connect(&studio_, &SceneStudio::restyled, this, [this] {
    shown_.reset();
    refresh();
  });
  const auto go = [this](const QListWidgetItem* item) {
    const int line = item->data(kLine).toInt();
    if (line > 0 && item->data(kFile).toString() == text_of(studio_.bench().file().string()))
      studio_.run(fmt::format("go {} {}", line, item->data(kColumn).toInt()));
  };
  connect(this, &QListWidget::itemClicked, this, go);
  connect(this, &QListWidget::itemActivated, this, go);
}

void ProblemList::refresh() {
  const auto problems = studio_.bench().status().problems;
  if (problems == shown_) return;
  shown_ = problems;
  clear();
  for (const Diagnostic& each : problems->all()) {
    const bool error = each.severity == Severity::error;
    QString text =
        QString("%1:%2  %3").arg(each.where.line).arg(each.where.column).arg(text_of(each.message));
    if (!each.hint.empty()) text += "\n" + text_of(each.hint);
    auto* item = new QListWidgetItem(text);
    item->setForeground(error ? theme().error : theme().text);
    item->setData(kLine, each.where.line);
    item->setData(kColumn, each.where.column);
    item->setData(kFile, text_of(each.where.file));
    item->setData(Qt::AccessibleTextRole, (error ? tr("Error: ") : tr("Warning: ")) + text);
    addItem(item);
  }
}

OutlineTree::OutlineTree(SceneStudio& studio) : studio_(studio) {
  setObjectName("outline");
  setAccessibleName(tr("Outline"));
  setHeaderLabels({tr("name"), tr("kind")});
  header()->setStretchLastSection(true);
  setRootIsDecorated(true);
  connect(&studio_, &SceneStudio::analysed, this, &OutlineTree::refresh);
  const auto go = [this](const QTreeWidgetItem* item) {
    studio_.run(
        fmt::format("go {} {}", item->data(0, kLine).toInt(), item->data(0, kColumn).toInt()));
  };
  connect(this, &QTreeWidget::itemClicked, this, go);
  connect(this, &QTreeWidget::itemActivated, this, go);
}

void OutlineTree::refresh() {
  if (!studio_.bench().has_document()) return;
  const std::vector<language::OutlineItem> items =
      language::outline_of(*studio_.bench().analysis());
  QStringList rows;
  const std::function<void(const language::OutlineItem&)> list =
      [&](const language::OutlineItem& each) {
        rows << QString("%1 %2 %3 %4")
                    .arg(text_of(each.name), text_of(each.detail))
                    .arg(each.where.line)
                    .arg(each.where.column);
        for (const language::OutlineItem& child : each.children) list(child);
      };
  for (const language::OutlineItem& each : items) list(each);
  if (rows == shown_) return;
  shown_ = rows;
  clear();
  const std::function<QTreeWidgetItem*(const language::OutlineItem&)> made =
      [&](const language::OutlineItem& each) {
        auto* item = new QTreeWidgetItem({text_of(each.name), text_of(each.detail)});
        item->setData(0, kLine, each.where.line);
        item->setData(0, kColumn, each.where.column);
        for (const language::OutlineItem& child : each.children) item->addChild(made(child));
        return item;
      };
  for (const language::OutlineItem& each : items) addTopLevelItem(made(each));
}

}  // namespace vug::studio
