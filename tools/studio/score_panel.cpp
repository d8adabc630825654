// SPDX-License-Identifier: Apache-2.0
#include "score_panel.h"

#include "named_button.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QVBoxLayout>

namespace vug::studio {
namespace {

QLabel* value_label(const QString& name) {
  auto* out = new QLabel("–");
  out->setProperty("role", "value");
  out->setAccessibleName(name);
  return out;
}

QString row(const QString& name, const fit::FacadeScore& score) {
  return QString("<tr><td>%1&nbsp;&nbsp;</td><td>%2&nbsp;&nbsp;</td><td>%3 bits</td></tr>")
      .arg(name.toHtmlEscaped())
      .arg(score.score, 0, 'f', 4)
      .arg(score.complexity, 0, 'f', 0);
}

}  // namespace

ScorePanel::ScorePanel(Studio& studio) : studio_(studio) {
  setObjectName("scores");
  setAccessibleName(tr("Scores"));
  setFixedWidth(312);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(14, 10, 14, 8);
  column->setSpacing(6);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(16);
  grid->setVerticalSpacing(0);
  score_ = value_label(tr("Score s(T)"));
  complexity_ = value_label(tr("Complexity c(T)"));
  differing_ = value_label(tr("Differing pixels"));
  const auto add = [&](int at, const QString& name, const QString& help, QLabel* value) {
    auto* heading = new QLabel(name);
    heading->setProperty("role", "heading");
    heading->setToolTip(help);
    value->setToolTip(help);
    grid->addWidget(heading, 0, at);
    grid->addWidget(value, 1, at);
  };
  add(0, tr("Score s(T)"), tr("1 explains all pixels with the simplest tree"), score_);
  add(1, tr("Complexity c(T)"), tr("Bits that describe the tree"), complexity_);
  add(2, tr("Differing"), tr("Pixels that contradict the tree; D marks them"), differing_);
  column->addLayout(grid);
  comparisons_ = new QLabel;
  comparisons_->setTextFormat(Qt::RichText);
  comparisons_->setAccessibleName(tr("Compared sessions"));
  comparisons_->hide();
  column->addWidget(comparisons_);
  auto* line = new QHBoxLayout;
  fit_ = named_button(tr("Fit to photo"), "fit");
  fit_->setEnabled(false);
  fit_->setToolTip(tr("Finds the most likely tree; its result can be edited"));
  connect(fit_, &QPushButton::clicked, this,
          [this] { studio_.run(studio_.bench().fitting() ? "stop" : "fit"); });
  line->addWidget(fit_);
  stage_ = new QLabel;
  stage_->setAccessibleName(tr("Stage of the fit"));
  line->addWidget(stage_, 1);
  column->addLayout(line);
  progress_ = new QProgressBar;
  progress_->setAccessibleName(tr("Progress of the fit"));
  progress_->setTextVisible(false);
  progress_->setRange(0, 1000);
  progress_->hide();
  column->addWidget(progress_);
  column->addStretch();
  connect(&studio_, &Studio::changed, this, &ScorePanel::refresh);
}

void ScorePanel::refresh() {
  const workbench::FacadeBench& bench = studio_.bench();
  if (!bench.has_document()) return;
  if (const auto& score = bench.score()) {
    score_->setText(QString::number(score->score, 'f', 4));
    complexity_->setText(tr("%1 bits").arg(score->complexity, 0, 'f', 0));
    const double share = 100.0 * static_cast<double>(score->differing) /
                         static_cast<double>(std::max<size_t>(1, score->mask.size()));
    differing_->setText(QString("%1 %").arg(share, 0, 'f', 1));
  } else {
    for (QLabel* each : {score_, complexity_, differing_}) each->setText("–");
  }
  score_->setToolTip(text_of(bench.score_reason()));
  const std::pair<const void*, size_t> now{bench.scorer(), bench.comparisons().size()};
  if (compared_ != now) comparisons_->setText(comparison_text());
  compared_ = now;
  comparisons_->setVisible(!bench.comparisons().empty());
  show_fit();
}

QString ScorePanel::comparison_text() const {
  const workbench::FacadeBench& bench = studio_.bench();
  if (!bench.scorer()) return "";
  QString out = "<table>";
  for (const workbench::Comparison& each : bench.comparisons()) {
    try {
      out += row(text_of(each.file), bench.scorer()->score(each.state.tree()));
    } catch (const Error& error) {
      out += QString("<tr><td>%1</td><td colspan=2>%2</td></tr>")
                 .arg(text_of(each.file).toHtmlEscaped(), text_of(error.what()).toHtmlEscaped());
    }
  }
  return out + "</table>";
}

void ScorePanel::show_fit() {
  const workbench::FacadeBench& bench = studio_.bench();
  const bool runs = bench.fitting();
  fit_->setEnabled(runs || !bench.photo().empty());
  fit_->setText(runs ? tr("Stop") : tr("Fit to photo"));
  fit_->setAccessibleName(fit_->text());
  progress_->setVisible(runs);
  progress_->setValue(static_cast<int>(1000 * bench.fit_update().fraction));
  stage_->setText(runs ? text_of(bench.fit_update().stage) : QString());
}

}  // namespace vug::studio
