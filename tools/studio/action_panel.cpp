// SPDX-License-Identifier: Apache-2.0
#include "action_panel.h"

#include "theme.h"

#include <vug/modeller/query.h>
#include <vug/workbench/action_reason.h>

#include <QAbstractButton>
#include <QEvent>
#include <QLabel>
#include <QPainter>
#include <QRegularExpression>
#include <QVBoxLayout>

namespace vug::studio {
namespace {

/// A wide button with a pictogram, a title, a line of detail and its key.
class ActionButton : public QAbstractButton {
 public:
  ActionButton(const QString& title, const QString& detail, const QString& key, QWidget* parent)
      : QAbstractButton(parent), detail_(detail), key_(key) {
    setText(title);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_Hover);
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  }
  QSize sizeHint() const override { return {220, std::max(40, 2 * fontMetrics().height() + 8)}; }

 protected:
  void paintEvent(QPaintEvent*) override {
    const Theme& t = theme();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    const bool hot = isEnabled() && (underMouse() || hasFocus());
    painter.setPen(hot ? t.accent : isEnabled() ? t.border : Qt::transparent);
    painter.setBrush(isEnabled() ? (isDown() ? t.window : t.panel) : Qt::transparent);
    painter.drawRoundedRect(frame, 6, 6);
    icon().paint(&painter, QRect(8, (height() - 32) / 2, 32, 32), Qt::AlignCenter,
                 isEnabled() ? QIcon::Normal : QIcon::Disabled);
    const QRect room = rect().adjusted(50, 0, -26, 0);
    const int middle = height() / 2;
    const auto elided = [&](const QString& text) {
      return painter.fontMetrics().elidedText(text, Qt::ElideRight, room.width());
    };
    painter.setPen(isEnabled() ? t.text : t.muted);
    const bool two = !detail_.isEmpty();
    painter.drawText(QRect(room.x(), 0, room.width(), two ? middle : height()),
                     two ? Qt::AlignBottom : Qt::AlignVCenter, elided(text()));
    QFont small = font();
    small.setPointSizeF(0.85 * small.pointSizeF());
    painter.setFont(small);
    painter.setPen(t.muted);
    if (two)
      painter.drawText(QRect(room.x(), middle, room.width(), middle), Qt::AlignTop,
                       elided(detail_));
    painter.drawText(rect().adjusted(0, 0, -10, 0), Qt::AlignRight | Qt::AlignVCenter, key_);
  }

 private:
  QString detail_, key_;
};

/// "Rows", "FacadeRow, PartFacade": the words and the parts of an action's name.
std::pair<QString, QString> action_title(const std::string& name) {
  const QString text = text_of(name);
  const qsizetype open = text.indexOf('(');
  QString title = text.left(open < 0 ? text.size() : open);
  // "RegularIdenticalGrid" in words.
  title.replace(QRegularExpression("(?<=[a-z])(?=[A-Z])"), " ");
  title = title.left(1).toUpper() + title.mid(1).toLower();
  QString parts = open < 0 ? QString() : text.mid(open + 1).chopped(1);
  return {title, parts};
}

}  // namespace

ActionPanel::ActionPanel(Studio& studio) : studio_(studio) {
  setObjectName("actions");
  setAccessibleName(tr("Actions"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(10, 10, 10, 10);
  column->setSpacing(4);
  auto* heading = new QLabel(tr("Actions"));
  heading->setProperty("role", "heading");
  column->addWidget(heading);
  list_ = new QVBoxLayout;
  list_->setSpacing(4);
  column->addLayout(list_);
  column->addStretch();
  connect(&studio_, &Studio::opened, this, &ActionPanel::rebuild);
  connect(&studio_, &Studio::restyled, this, [this] { shown_.reset(); });
  connect(&studio_, &Studio::changed, this, &ActionPanel::refresh);
}

void ActionPanel::rebuild() {
  shown_.reset();
  for (QAbstractButton* each : buttons_) {
    list_->removeWidget(each);
    each->hide();
    each->deleteLater();
  }
  buttons_.clear();
  const auto& actions = studio_.bench().state().style().actions();
  for (size_t i = 0; i < actions.size(); ++i) {
    const auto [title, parts] = action_title(actions[i].name);
    auto* button = new ActionButton(title, parts, i < 9 ? QString::number(i + 1) : "", this);
    button->setObjectName(QString("action %1").arg(i + 1));
    button->setAccessibleName(parts.isEmpty() ? title : title + ", " + parts);
    button->installEventFilter(this);
    connect(button, &QAbstractButton::clicked, this, [this, i] { perform(static_cast<int>(i)); });
    list_->addWidget(button);
    buttons_.push_back(button);
  }
}

void ActionPanel::refresh() {
  const workbench::FacadeBench& bench = studio_.bench();
  if (!bench.has_document()) return;
  const std::pair now{bench.revision(), bench.selected()};
  if (shown_ == now) return;  // zooming and scrolling change no action
  shown_ = now;
  const auto choices = modeller::actions(bench.state(), bench.selected());
  for (size_t i = 0; i < choices.size() && i < buttons_.size(); ++i) {
    const QString why = text_of(workbench::reason_text(choices[i].choice));
    QAbstractButton& button = *buttons_[i];
    button.setEnabled(why.isEmpty());
    button.setIcon(action_icon(text_of(choices[i].action->name), why.isEmpty()));
    const QString text =
        why.isEmpty() ? tr("Applies %1 to the selected part.").arg(text_of(choices[i].action->name))
                      : why;
    button.setToolTip(text);
    button.setStatusTip(text);
    button.setAccessibleDescription(text);
  }
}

void ActionPanel::perform(int index) {
  workbench::FacadeBench& bench = studio_.bench();
  if (!bench.has_document()) return;
  const auto choices = modeller::actions(bench.state(), bench.selected());
  if (index >= static_cast<int>(choices.size())) return;
  const modeller::ActionChoice& choice = choices[static_cast<size_t>(index)];
  if (const std::string why = workbench::reason_text(choice.choice); !why.empty()) {
    Q_EMIT studio_.message(text_of(why), true);
    return;
  }
  studio_.run(workbench::action_edit(bench.state(), bench.selected(), *choice.action));
}

int ActionPanel::index_of(const QObject* button) const {
  for (size_t i = 0; i < buttons_.size(); ++i)
    if (buttons_[i] == button) return static_cast<int>(i);
  return -1;
}

bool ActionPanel::eventFilter(QObject* watched, QEvent* event) {
  const int index = index_of(watched);
  if (index >= 0 && (event->type() == QEvent::Enter || event->type() == QEvent::FocusIn)) {
    const QAbstractButton& button = *buttons_[static_cast<size_t>(index)];
    if (button.isEnabled()) studio_.hover_action(index);
    Q_EMIT studio_.message(button.toolTip(), false);
  }
  if (index >= 0 && (event->type() == QEvent::Leave || event->type() == QEvent::FocusOut)) {
    studio_.hover_action(-1);
    Q_EMIT studio_.message("", false);
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace vug::studio
