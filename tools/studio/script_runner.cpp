// SPDX-License-Identifier: Apache-2.0
#include "script_runner.h"

#include "theme.h"

#include <vug/base/atomic_file.h>
#include <vug/base/diagnostics.h>
#include <vug/workbench/query.h>
#include <vug/workbench/words.h>

#include <fmt/format.h>
#include <QAbstractButton>
#include <QApplication>
#include <QElapsedTimer>
#include <QTest>
#include <sstream>

namespace vug::studio {
namespace {

constexpr int kPatience = 180'000;  // milliseconds that `wait` waits

/// A text property of a widget or of the window, for `expect widget NAME PROPERTY = TEXT`.
std::string property_of(const std::string& name, const std::string& property) {
  const QWidget& widget = find_widget(name);
  if (property == "enabled") return widget.isEnabled() ? "yes" : "no";
  if (property == "focus") return widget.hasFocus() ? "yes" : "no";
  if (property == "tooltip") return widget.toolTip().toStdString();
  if (property == "description") return widget.accessibleDescription().toStdString();
  if (property == "cursor") return std::to_string(widget.cursor().shape());
  return widget.property(property.c_str()).toString().toStdString();
}

}  // namespace

QWidget& find_widget(const std::string& name) {
  std::vector<std::string> names;
  for (QWidget* each : QApplication::allWidgets()) {
    if (each->objectName().isEmpty() || !each->isVisible()) continue;
    if (each->objectName() == QString::fromStdString(name)) return *each;
    names.push_back(each->objectName().toStdString());
  }
  throw Error(ErrorCode::bad_input, fmt::format("no visible widget '{}'", name), {},
              suggestion(name, names));
}

void ScriptRunner::run(const std::filesystem::path& file) {
  std::istringstream text(read_text(file));
  std::string line;
  for (int number = 1; std::getline(text, line); ++number) {
    try {
      run_line(line);
    } catch (const Error& error) {
      throw error.at({file.string(), number, 1});
    }
    QApplication::processEvents();
  }
}

void ScriptRunner::run_line(const std::string& line) {
  const std::vector<std::string> words = workbench::split_words(line);
  if (words.empty()) return;
  const std::string& name = words[0];
  if (name == "expect") return expect({words.begin() + 1, words.end()});
  if (name == "grab") return grab(words);
  if (name == "wait") return wait(words);
  if (name == "theme" && words.size() == 2) {
    set_theme(*qApp, QString::fromStdString(words[1]));
    return host_.restyle();
  }
  if (name == "resize" && words.size() == 3) {
    host_.window().resize(static_cast<int>(workbench::parse_number(words[1])),
                          static_cast<int>(workbench::parse_number(words[2])));
    return;
  }
  if (name == "reset-heartbeat") return heartbeat_.reset();
  if (name == "run" && words.size() == 2) return run(words[1]);
  if (!host_.send_event(words) && !send_events(host_.window(), words)) host_.execute(line);
}

void ScriptRunner::expect(const std::vector<std::string>& words) {
  const auto part = [&](size_t from) {
    if (words.size() != from + 2)
      throw Error(ErrorCode::bad_input, "wrong number of words in an assertion", {},
                  "expect NAME = TEXT");
    return std::pair(words[from], words[from + 1]);
  };
  const std::string name = words.empty() ? "" : words[0];
  std::string actual;
  size_t at = 1;
  if (name == "message") {
    actual = host_.message();
  } else if (name == "audit") {
    actual = audit(host_.window()).toStdString();
  } else if (name == "heartbeat") {
    actual = std::to_string(heartbeat_.worst_work());
  } else if (name == "widget" && words.size() > 3) {
    actual = property_of(words[1], words[2]);
    at = 3;
  } else {
    return host_.expect(words);
  }
  const auto [relation, value] = part(at);
  workbench::expect_value(name, actual, relation, value);
}

void ScriptRunner::grab(const std::vector<std::string>& words) {
  if (words.size() != 3)
    throw Error(ErrorCode::bad_input, "wrong number of arguments of grab", {},
                "grab WIDGET FILE.png");
  QApplication::processEvents();
  if (!find_widget(words[1]).grab().save(QString::fromStdString(words[2])))
    throw Error(ErrorCode::io, fmt::format("cannot write '{}'", words[2]));
}

/// `wait idle` waits for the threads of the bench, `wait N` for N milliseconds.
void ScriptRunner::wait(const std::vector<std::string>& words) {
  const bool idle = words.size() > 1 && words[1] == "idle";
  const int most =
      idle || words.size() < 2 ? kPatience : static_cast<int>(workbench::parse_number(words[1]));
  QElapsedTimer passed;
  passed.start();
  while (passed.elapsed() < most && (!idle || host_.busy())) {
    QTest::qWait(10);
    if (idle) host_.poll();
  }
  if (idle && host_.busy())
    throw Error(ErrorCode::bad_input, "the work did not end within three minutes");
}

}  // namespace vug::studio
