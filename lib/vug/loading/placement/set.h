// SPDX-License-Identifier: Apache-2.0
// The set of a scene: its solids, props and lights in world space, as far as the text gives their
// positions. Scattered instances lie on surfaces that would have to be built first.
#pragma once

#include <vug/loading/load.h>
#include <vug/loading/placement/solid.h>

namespace vug::loading {

/// An object, or an instance of a model.
struct SetPiece {
  std::string name;      ///< "chest", or "instance 2 of chests".
  SourceLocation where;  ///< Its declaration.
  std::vector<Solid> solids;
  bool floating = false;  ///< May be in mid-air: the text says so, or it has lights of its own.
  bool modelled = false;  ///< A level set of this scene, whose field says where it is.
};

/// A finite light.
struct SetLight {
  std::string name;
  SourceLocation where;
  std::vector<Vec3d> points;  ///< Its centre, then points at its rim or its corners.
};

struct Set {
  std::vector<SetPiece> pieces;
  std::vector<SetLight> lights;
};

/// The set of a part of the scene's shot.
Set set_of(const Loaded& scene, const shot::Shot& part);

/// Which solids are rock to a camera or a light.
using IsOpen = bool (Solid::*)(const Vec3d&) const;

/// The first solid that certainly contains the point and is not open; null if there is none.
const Solid* rock_at(const Set& set, const Vec3d& p, IsOpen is_open, Accuracy accuracy);

}  // namespace vug::loading
