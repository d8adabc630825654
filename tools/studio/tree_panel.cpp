// SPDX-License-Identifier: Apache-2.0
#include "tree_panel.h"

#include "theme.h"

#include <QHeaderView>
#include <QLabel>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace vug::studio {

TreePanel::TreePanel(Studio& studio) : studio_(studio) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(10, 10, 4, 4);
  column->setSpacing(4);
  auto* heading = new QLabel(tr("Derivation tree"));
  heading->setProperty("role", "heading");
  column->addWidget(heading);
  tree_ = new QTreeWidget;
  tree_->setObjectName("tree");
  tree_->setAccessibleName(tr("Derivation tree"));
  tree_->setColumnCount(2);
  tree_->setHeaderLabels({tr("Symbol"), tr("Rule")});
  tree_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  tree_->header()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  tree_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  tree_->setIndentation(14);
  tree_->setUniformRowHeights(true);
  tree_->setFrameShape(QFrame::NoFrame);
  tree_->setTabKeyNavigation(false);
  column->addWidget(tree_);
  connect(tree_, &QTreeWidget::currentItemChanged, this, &TreePanel::selected_by_user);
  connect(tree_, &QTreeWidget::itemCollapsed, this, [this](QTreeWidgetItem* item) {
    if (!updating_) folded_.insert(item->data(0, Qt::UserRole).toString());
  });
  connect(tree_, &QTreeWidget::itemExpanded, this,
          [this](QTreeWidgetItem* item) { folded_.erase(item->data(0, Qt::UserRole).toString()); });
  connect(&studio_, &Studio::opened, this, [this] { shown_ = 0; });
  connect(&studio_, &Studio::restyled, this, [this] { shown_ = 0; });
  connect(&studio_, &Studio::changed, this, &TreePanel::refresh);
}

void TreePanel::refresh() {
  if (!studio_.bench().has_document()) return;
  updating_ = true;
  if (shown_ != studio_.bench().revision()) rebuild();
  const auto selected = static_cast<size_t>(std::max(0, studio_.bench().selected()));
  if (selected < items_.size()) {
    tree_->setCurrentItem(items_[selected]);
    tree_->scrollToItem(items_[selected]);
  }
  updating_ = false;
}

void TreePanel::rebuild() {
  shown_ = studio_.bench().revision();
  tree_->clear();
  items_.clear();
  const modeller::FacadeState& state = studio_.bench().state();
  for (size_t i = 0; i < state.tree().nodes.size(); ++i) {
    const int index = static_cast<int>(i);
    const facade::Node& node = state.tree().nodes[i];
    auto* item = node.parent < 0 ? new QTreeWidgetItem(tree_)
                                 : new QTreeWidgetItem(items_[static_cast<size_t>(node.parent)]);
    items_.push_back(item);
    QString symbol = text_of(node.symbol);
    if (!node.copies.empty()) symbol += QString(" ×%1").arg(node.copies.size() + 1);
    item->setText(0, symbol);
    if (state.rule(index) >= 0)
      item->setText(1, text_of(state.style().rule_name(state.rule(index))));
    else if (node.stuck)
      item->setText(1, tr("open"));
    item->setForeground(1,
                        node.stuck ? theme().open.darker(theme().dark ? 100 : 135) : theme().muted);
    item->setData(0, Qt::UserRole, text_of(state.path(index)));
    const QString size = tr("%1 x %2 m at (%3, %4)")
                             .arg(node.rect.width, 0, 'g', 4)
                             .arg(node.rect.height, 0, 'g', 4)
                             .arg(node.rect.x, 0, 'g', 4)
                             .arg(node.rect.y, 0, 'g', 4);
    item->setToolTip(0, text_of(state.path(index)) + "  " + size);
    item->setToolTip(1, item->text(1));
    if (node.element)
      item->setForeground(0, colour_of(node.symbol).lighter(theme().dark ? 150 : 100));
  }
  for (QTreeWidgetItem* item : items_)
    item->setExpanded(!folded_.count(item->data(0, Qt::UserRole).toString()));
}

void TreePanel::selected_by_user() {
  if (updating_ || !tree_->currentItem()) return;
  const QString path = tree_->currentItem()->data(0, Qt::UserRole).toString();
  studio_.run("select " + path.toStdString());
}

}  // namespace vug::studio
