// SPDX-License-Identifier: Apache-2.0
// Draws the handles, lights and cameras over the picture of a scene.
#pragma once

#include <vug/workbench/scene_overlay.h>

#include <QPainter>

namespace vug::studio {

/// `hovered`: the handle below the mouse; empty for none. Positions are divided by `ratio`, the
/// pixels of the picture for each of the painter.
void paint_overlay(QPainter& painter, const workbench::SceneOverlay& overlay,
                   const std::string& hovered, double ratio);

}  // namespace vug::studio
