// SPDX-License-Identifier: Apache-2.0
// The speleothems that grow at the drips of a graph, as plain data. Metres, y up.
#pragma once

#include <vug/drips/graph.h>
#include <vug/field/field.h>

#include <string>
#include <vector>

namespace vug::drips {

/// A piece is the lower end of a stalactite that broke, and lies on the floor.
enum class FormKind { straw, stalactite, stalagmite, column, piece };

/// E.g. "stalactite" or "broken piece".
const char* kind_name(FormKind kind);

struct Form {
  FormKind kind = FormKind::stalactite;
  int64_t drip = 0;   ///< The id of its drop.
  Vec3d top{0.0};     ///< On the roof; of stalagmites, the apex; of pieces, the broken end.
  Vec3d bottom{0.0};  ///< The tip; of stalagmites and columns, on the floor.
  double radius = 0;  ///< At the root; of stalagmites and columns, of the trunk.
  double root = 0;  ///< The length by which it continues into the rock, at the roof and the floor.
  double scatter = 0;      ///< Radius of the flat top of a stalagmite.
  double apex_cosine = 1;  ///< See field::StalagmiteForm.
  double waist = 0;        ///< Height of a column at which both parts have met, 0..1.
  double coat = 0;         ///< Mean thickness of the calcite over a column.
  double broken = 0;       ///< Share of a stalactite's length that broke off.
  double regrown = 0;      ///< Length in metres of the end that has grown on the stump since then.
  double dome = 0;         ///< See field::dome_radius: scale of the foot of a massive stalagmite.
  int flutes = 0;          ///< Vertical ribs around a column or a thick trunk.
  double offset = 0;       ///< Distance between the axes of both parts of a column, metres.
  double heading = 0;      ///< The angle about y of this offset in radians.
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

/// In the order of their drips, without pieces. Forms that are too small for the radius of the tips
/// are left out: a stalactite is at least six of these radii long, so that it is not a thumb.
std::vector<Form> forms_of(const Graph& graph, const FormOptions& options);

/// The pieces of the broken stalactites among the forms that lie still on the rock below.
std::vector<Form> fallen_pieces(const field::Field& rock, const std::vector<Form>& forms,
                                const Graph& graph, const FormOptions& options);

/// E.g. "stalagmite 214: drip 96 on joint 3, 55 s a drop, 41,000 years"; the number is the form's.
std::string explain(const Form& form, size_t number, const Graph& graph);

}  // namespace vug::drips
