// SPDX-License-Identifier: Apache-2.0
// The speleothems that grow at the drips of a graph, as plain data. Metres, y up.
#pragma once

#include <vug/drips/graph.h>
#include <vug/field/field.h>

#include <vector>

namespace vug::drips {

/// A column is the calcite that covers a stalactite and a stalagmite since they met; both remain
/// forms of their own inside it. A piece is the lower end of a stalactite that broke, and lies on
/// the floor.
enum class FormKind { straw, stalactite, stalagmite, column, piece };

/// E.g. "stalactite" or "broken piece".
const char* kind_name(FormKind kind);

struct Form {
  FormKind kind = FormKind::stalactite;
  int64_t drip = 0;   ///< The id of its drop.
  Vec3d top{0.0};     ///< On the roof; of stalagmites, the apex; of pieces, the broken end.
  Vec3d bottom{0.0};  ///< The tip; of stalagmites and columns, on the floor.
  /// The length of a young hanging form that is still in the roof: as its tip is as wide as voxels
  /// need, it comes out of the roof as a whole.
  double sunk = 0;
  double radius = 0;  ///< At the root; of stalagmites and columns, of the trunk.
  double root = 0;  ///< The length by which it continues into the rock, at the roof and the floor.
  double scatter = 0;      ///< Radius of the flat top of a stalagmite.
  double apex_cosine = 1;  ///< See field::StalagmiteForm.
  double waist = 0;        ///< Height of a column at which both parts have met, 0..1.
  double coat = 0;         ///< Mean thickness of the calcite over a column.
  double cover = 1;        ///< Share of a column's radius to which the calcite has grown, 0..1.
  double broken = 0;       ///< Share of a stalactite's length that broke off.
  double since = 0;        ///< Years since a stalactite broke, or since both parts of a column met.
  double regrown = 0;      ///< Length in metres of the end that has grown on the stump since then.
  double dome = 0;         ///< See field::dome_radius: scale of the foot of a massive stalagmite.
  int flutes = 0;          ///< Vertical ribs around a column or a thick trunk.
  double ribs = 0;         ///< Their depth over that of old trunks, 0..1.
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
  double age = 10000;        ///< The age of the oldest drips in years.
  /// The age of the oldest drips to which the years in which stalactites break refer.
  double final_age = 10000;
  uint64_t seed = 1;
};

/// In the order of their drips, without pieces. Each form is a continuous function of the age, and
/// lengths and radii increase with it, but for stalactites that break. A stalactite is at least six
/// radii of the tip long, so that it is not a thumb; while it grows from three to six of them, it
/// comes out of the roof.
std::vector<Form> forms_of(const Graph& graph, const FormOptions& options);

/// The pieces of the broken stalactites among the forms that lie still on the rock below.
std::vector<Form> fallen_pieces(const field::Field& rock, const std::vector<Form>& forms,
                                const Graph& graph, const FormOptions& options);

}  // namespace vug::drips
