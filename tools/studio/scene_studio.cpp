// SPDX-License-Identifier: Apache-2.0
#include "scene_studio.h"

#include <vug/workbench/scene_command.h>
#include <vug/workbench/words.h>

namespace vug::studio {
namespace {

/// Milliseconds without a key after which a text is analysed and built: libfive Studio waits as
/// long. Longer rests end the undo step.
constexpr int kTyped = 250, kRest = 700;
/// Milliseconds that a drag lets a build run before it begins the next one.
constexpr int kDragBuild = 1000;
/// Milliseconds after which a file that another program writes is read.
constexpr int kTouched = 100;

/// Whether more lines of this kind follow while the mouse moves: they have a key for merging.
bool is_drag(const std::string& command, const std::string& line) {
  const size_t words =
      command == "param" || command == "drag_handle" ? workbench::split_words(line).size() : 0;
  return command == "param" ? words > 3 : words > 5;
}

}  // namespace

SceneStudio::SceneStudio(QObject* parent)
    : BenchStudio(parent),
      bench_([this] {
        if (!pending_.exchange(true))
          QMetaObject::invokeMethod(this, &SceneStudio::poll, Qt::QueuedConnection);
      }),
      recorder_(bench_, workbench::journal_folder()),
      queue_(recorder_.folder()),
      runner_(queue_) {
  bench_.queue = &queue_;
  bench_.preset_folder = recorder_.folder();
  // What waited at the end of the last session goes on when the window is there.
  QTimer::singleShot(0, &runner_, &RenderRunner::update);
  typed_.setSingleShot(true);
  rest_.setSingleShot(true);
  touched_.setSingleShot(true);
  connect(&typed_, &QTimer::timeout, this, &SceneStudio::build);
  connect(&touched_, &QTimer::timeout, this, &SceneStudio::check_file);
  connect(&watcher_, &QFileSystemWatcher::fileChanged, this, [this] { touched_.start(kTouched); });
  connect(&rest_, &QTimer::timeout, this, [this] {
    if (bench_.has_document()) recorder_.run("end_step");
  });
}

void SceneStudio::set_caret(int line) {
  if (!bench_.has_document() || bench_.caret_line() == line) return;
  bench_.set_caret(line);
  Q_EMIT changed();
}

void SceneStudio::check_file() {
  if (!bench_.has_document()) return;
  // Programs that write safely replace the file, and the watcher loses a file that is replaced.
  const QString file = text_of(std::filesystem::absolute(bench_.file()).string());
  if (watcher_.files() != QStringList(file)) {
    if (!watcher_.files().isEmpty()) watcher_.removePaths(watcher_.files());
    if (std::filesystem::exists(bench_.file())) watcher_.addPath(file);
  }
  Q_EMIT file_changed(text_of(bench_.changed_on_disk()));
}

void SceneStudio::poll() {
  pending_ = false;
  if (waits_ && !shows_soon()) build();
  Q_EMIT news();
}

bool SceneStudio::shows_soon() const {
  return bench_.status().building && since_build_.isValid() && since_build_.elapsed() < kDragBuild;
}

void SceneStudio::build() {
  waits_ = false;
  typed_.stop();
  since_build_.start();
  bench_.build();
  Q_EMIT analysed();
  Q_EMIT news();
}

void SceneStudio::schedule(bool typing, bool drag) {
  if (typing) {
    typed_.start(kTyped);
    rest_.start(kRest);
  } else if (drag && shows_soon()) {  // pictures appear during the drag
    waits_ = true;
    Q_EMIT analysed();
  } else {
    build();
  }
}

void SceneStudio::execute(const std::string& line) {
  const workbench::SceneCommand* command = recorder_.run(line);
  if (!command) return;
  runner_.update();
  Q_EMIT message("", false);
  Q_EMIT changed();
  if (!bench_.has_document()) return;
  if (command->opens || command->saves) check_file();
  if (command->opens && recorder_.is_open_elsewhere())
    Q_EMIT message(tr("This scene is open in another window, too. What is saved there is reported "
                      "here."),
                   false);
  if (bench_.revision() != known_) {
    known_ = bench_.revision();
    schedule(command->name == "edit", is_drag(command->name, line));
  }
  Q_EMIT news();
}

bool SceneStudio::recover(const workbench::LostJournal& lost) {
  const uint64_t before = bench_.revision();
  bool complete = true;
  try {
    recorder_.recover(lost);
  } catch (const Error& error) {
    show(error);
    complete = false;
  }
  if (bench_.revision() == before) return complete;
  known_ = bench_.revision();
  Q_EMIT changed();
  build();
  return true;
}

}  // namespace vug::studio
