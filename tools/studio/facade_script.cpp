// SPDX-License-Identifier: Apache-2.0
// Events of scripts on the canvas. Positions are in metres on the facade's plane.
#include "facade_script.h"

#include "script_runner.h"

#include <vug/workbench/query.h>
#include <vug/workbench/words.h>

#include <fmt/format.h>
#include <QApplication>
#include <QTest>
#include <QWheelEvent>

namespace vug::studio {
namespace {

using Words = std::vector<std::string>;

QPoint canvas_point(MainWindow& window, const std::string& x, const std::string& y) {
  return window.canvas().at(workbench::parse_length(x), workbench::parse_length(y)).toPoint();
}

/// click canvas X Y
void click_canvas(MainWindow& window, const Words& words) {
  const QPoint at = canvas_point(window, words[2], words[3]);
  QTest::mouseMove(&window.canvas(), at);
  if (words[0] == "double-click")
    QTest::mouseDClick(&window.canvas(), Qt::LeftButton, {}, at);
  else
    QTest::mouseClick(&window.canvas(), Qt::LeftButton, {}, at);
}

/// drag line N [copy K] to LENGTH
void drag(Studio& studio, MainWindow& window, const Words& words) {
  require_words(words, 5, "drag line N [copy K] to LENGTH");
  const auto index = static_cast<size_t>(workbench::parse_number(words[2]));
  size_t instance = 0, at = 3;
  if (words[at] == "copy" && words.size() > at + 1) {
    instance = static_cast<size_t>(workbench::parse_number(words[at + 1]));
    at += 2;
  }
  if (words.size() != at + 2 || words[1] != "line" || words[at] != "to")
    throw Error(ErrorCode::bad_input, "invalid drag", {}, "drag line N [copy K] to LENGTH");
  const double to = workbench::parse_length(words[at + 1]);
  for (const workbench::Handle& each : studio.bench().current_handles()) {
    if (each.index != index || each.instance != instance) continue;
    // Motion along the handle's axis; mirrored copies move to the other side.
    const modeller::FacadeState& state = studio.bench().state();
    const int node = workbench::numbers_node(state, studio.bench().selected());
    const double ahead =
        workbench::own_position(state, node, each, each.x0 + 1, each.y0 + 1) - each.at;
    const double x = (each.x0 + each.x1) / 2, y = (each.y0 + each.y1) / 2;
    const double by = (to - each.at) / ahead;
    Canvas& canvas = window.canvas();
    const auto point = [&](double share) {
      return (each.upright ? canvas.at(x + share * by, y) : canvas.at(x, y + share * by)).toPoint();
    };
    QTest::mouseMove(&canvas, point(0));
    QTest::mousePress(&canvas, Qt::LeftButton, {}, point(0));
    for (const double share : {0.25, 0.5, 0.75, 1.0}) QTest::mouseMove(&canvas, point(share));
    QTest::mouseRelease(&canvas, Qt::LeftButton, {}, point(1));
    return;
  }
  throw Error(ErrorCode::bad_input, fmt::format("the selected part has no handle {}", index), {},
              "select a part with free numbers");
}

/// wheel X Y STEPS: over a point of the canvas.
void wheel_canvas(MainWindow& window, const Words& words) {
  require_words(words, 4, "wheel X Y STEPS");
  Canvas& canvas = window.canvas();
  const QPoint at = canvas_point(window, words[1], words[2]);
  QWheelEvent event(at, canvas.mapToGlobal(at), {},
                    {0, static_cast<int>(120 * workbench::parse_number(words[3]))}, Qt::NoButton,
                    {}, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&canvas, &event);
}

}  // namespace

void FacadeScript::expect(const Words& words) { workbench::expect(studio_.bench(), words); }

bool FacadeScript::send_event(const Words& words) {
  const std::string& name = words[0];
  const bool on_canvas = words.size() >= 4 && words[1] == "canvas";
  if (name == "frame")
    window_.canvas().frame();
  else if (on_canvas && (name == "click" || name == "double-click"))
    click_canvas(window_, words);
  else if (on_canvas && name == "hover")
    QTest::mouseMove(&window_.canvas(), canvas_point(window_, words[2], words[3]));
  else if (name == "drag")
    drag(studio_, window_, words);
  else if (name == "wheel")
    wheel_canvas(window_, words);
  else
    return false;
  return true;
}

}  // namespace vug::studio
