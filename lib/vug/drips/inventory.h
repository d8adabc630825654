// SPDX-License-Identifier: Apache-2.0
// The list of all speleothems of a cave with their sources, and the sentences that explain them.
#pragma once

#include <vug/drips/dripstone.h>

#include <string>
#include <vector>

namespace vug::drips {

/// One speleothem and the drip from which it grows. Metres and years.
struct Speleothem {
  const char* kind = "";  ///< As kind_name(FormKind), or "drapery" or "flowstone".
  int64_t drip = 0;       ///< The id of its seep, drop or landing.
  Vec3d top{0.0};         ///< Its highest point, or that of the film along which it grows.
  Vec3d bottom{0.0};      ///< The lowest one.
  double length = 0;      ///< That of a form, or of the film along which another one grows.
  double size = 0;        ///< The radius of a form, width of a drapery, thickness of flowstone.
  double interval = 0;    ///< Seconds between drops.
  double age = 0;         ///< Years.
  double since = 0;       ///< See Form::since.
  int plane = -1;         ///< See Node::plane.
};

/// A form as an entry of the list.
Speleothem listed(const Form& form);

/// The forms in their order, then draperies, then one flowstone for each source, which includes the
/// skirt around a stalagmite.
std::vector<Speleothem> inventory(const Dripstone& grown, const Graph& graph);

/// E.g. "stalagmite 214: drip 96 on joint 3, 55 s a drop, 41,000 years"; the number is that in the
/// inventory.
std::string explain(const Speleothem& speleothem, size_t number, const Graph& graph);

}  // namespace vug::drips
