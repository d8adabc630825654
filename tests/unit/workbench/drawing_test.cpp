// SPDX-License-Identifier: Apache-2.0
#include "bench.h"

#include <vug/facade/tree.h>
#include <vug/workbench/action_reason.h>

namespace vug::workbench {
namespace {

TEST(Drawing, ShowsEachInstanceOfEachElement) {
  FacadeBench bench;
  bench.open(paris_session());
  size_t elements = 0, open = 0;
  for (const Shape& each : shapes(bench.state())) {
    elements += each.kind == Shape::Kind::element;
    open += each.kind == Shape::Kind::open;
  }
  EXPECT_EQ(elements, facade::element_instances(bench.state().tree()).size());
  EXPECT_EQ(open, 0u);
}

TEST(Drawing, GhostsOfAnActionAreItsParts) {
  FacadeBench bench;
  run(bench, {"photo " + paris_photo() + " 15m", "act 0 mirror(SymmetricFacadeSide)"});
  const modeller::FacadeState& state = bench.state();
  const int side = state.find("0.0");
  for (const modeller::ActionChoice& each : modeller::actions(state, side)) {
    if (each.choice.reason != facade::Reason::none) {
      EXPECT_NE(reason_text(each.choice), "") << each.action->name;
      continue;
    }
    EXPECT_EQ(reason_text(each.choice), "");
    const modeller::FacadeState after =
        modeller::perform_edit(state, action_edit(state, side, *each.action));
    const std::vector<Shape> parts = ghosts(state, side, after);
    EXPECT_FALSE(parts.empty()) << each.action->name;
    EXPECT_EQ(parts.size() % 2, 0u) << "both sides";
  }
}

TEST(Drawing, PositionsSnapToRoundNumbersOfAboutAPixel) {
  EXPECT_EQ(snapped(0.8123, 26), 0.8);
  EXPECT_EQ(snapped(0.8323, 26), 0.85);
  EXPECT_EQ(snapped(-0.8123, 150), -0.81);
  EXPECT_EQ(snapped(0.8123, 1e6), 0.812);
  EXPECT_EQ(snapped(3.4, 1), 3);
}

TEST(CanvasView, ZoomKeepsThePointUnderTheCursor) {
  const CanvasView view = CanvasView::whole(15, 19.75, 900, 700);
  EXPECT_NEAR(view.to_canvas_y(0) - view.to_canvas_y(19.75), 19.75 * view.scale, 1e-9);
  const double x = view.to_facade_x(321), y = view.to_facade_y(123);
  const CanvasView near = view.zoomed(3, 321, 123);
  EXPECT_NEAR(near.scale, 3 * view.scale, 1e-9);
  EXPECT_NEAR(near.to_facade_x(321), x, 1e-9);
  EXPECT_NEAR(near.to_facade_y(123), y, 1e-9);
  EXPECT_EQ(view.zoomed(1e9, 0, 0).scale, kMaxScale);
  EXPECT_NEAR(near.panned(10, 0).to_facade_x(331), x, 1e-9);
}

}  // namespace
}  // namespace vug::workbench
