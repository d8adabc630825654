// SPDX-License-Identifier: Apache-2.0
#include "studio.h"

namespace vug::studio {

Studio::Studio(QObject* parent)
    : BenchStudio(parent),
      bench_([this] {
        if (!pending_.exchange(true))
          QMetaObject::invokeMethod(this, &Studio::poll, Qt::QueuedConnection);
      }),
      recorder_(bench_, workbench::journal_folder()) {}

void Studio::poll() {
  pending_ = false;
  try {
    const bool fitted = bench_.fitting();
    if (bench_.poll()) Q_EMIT changed();
    if (fitted && !bench_.busy() && !bench_.fit_note().empty())
      Q_EMIT message(tr("Fitted; %1.").arg(text_of(bench_.fit_note())), false);
    if (bench_.fit_update().error) Q_EMIT message(text_of(*bench_.fit_update().error), true);
  } catch (const Error& error) {
    Q_EMIT message(text_of(error.what()), true);
    Q_EMIT changed();
  }
}

void Studio::execute(const std::string& line) {
  const workbench::Command* command = recorder_.run(line);
  hovered_action_ = -1;
  Q_EMIT message("", false);
  if (command && command->opens) Q_EMIT opened();
  Q_EMIT changed();
}

bool Studio::recover(const workbench::LostJournal& lost) {
  const uint64_t before = bench_.revision();
  const auto opened_one = [&] { return bench_.revision() != before; };
  try {
    recorder_.recover(lost);
  } catch (const Error& error) {
    if (opened_one()) Q_EMIT opened();
    show(error);
    return opened_one();
  }
  Q_EMIT opened();
  Q_EMIT changed();
  return true;
}

bool Studio::run(const modeller::Edit& edit) { return run(to_string(edit)); }

void Studio::end_preview() {
  bench_.end_preview();
  Q_EMIT changed();
}

void Studio::select(int node) {
  if (node != bench_.selected()) run("select " + bench_.state().path(node));
}

void Studio::hover_action(int index) {
  if (index == hovered_action_) return;
  hovered_action_ = index;
  Q_EMIT hovered();
}

}  // namespace vug::studio
