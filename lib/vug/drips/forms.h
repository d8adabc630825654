// SPDX-License-Identifier: Apache-2.0
// The speleothems that grow at the drips of a graph, as plain data. Metres, y up.
#pragma once

#include <vug/drips/graph.h>

#include <string>
#include <vector>

namespace vug::drips {

enum class FormKind { straw, stalactite, stalagmite, column };

struct Form {
  FormKind kind = FormKind::stalactite;
  int64_t drip = 0;   ///< The id of its drop.
  Vec3d top{0.0};     ///< On the roof; of stalagmites, the apex.
  Vec3d bottom{0.0};  ///< The tip; of stalagmites and columns, on the floor.
  double radius = 0;  ///< At the root; of stalagmites and columns, of the trunk.
  double root = 0;  ///< The length by which it continues into the rock, at the roof and the floor.
  double scatter = 0;      ///< Radius of the flat top of a stalagmite.
  double apex_cosine = 1;  ///< See field::StalagmiteForm.
  double waist = 0;        ///< Height of a column at which both parts have met, 0..1.
  double coat = 0;         ///< Mean thickness of the calcite over a column.
  double broken = 0;       ///< Share of a stalactite's length that broke off.
  double interval = 0;     ///< Seconds between drops.
  double age = 0;          ///< Years.
  int plane = -1;          ///< See Node::plane.
};

struct FormOptions {
  double girth = 0.05;       ///< As GraphOptions.
  double tip = 0.00255;      ///< Least radius of a tip: half a straw, or what the voxels can carry.
  double stalagmites = 0.6;  ///< The share of the landings on which stalagmites stand.
  double broken = 0.07;      ///< The share of the stalactites that broke.
  uint64_t seed = 1;
};

/// In the order of their drips. Forms that are too small for the radius of the tips are left out:
/// a stalactite is at least six of these radii long, so that it is not a thumb.
std::vector<Form> forms_of(const Graph& graph, const FormOptions& options);

/// E.g. "stalagmite 214: drip 96 on joint 3, 55 s a drop, 41,000 years"; the number is the form's.
std::string explain(const Form& form, size_t number, const Graph& graph);

}  // namespace vug::drips
