// SPDX-License-Identifier: Apache-2.0
// The field of swept sections: the minimum over the segments of all passages, with fillets where
// passages meet.
#pragma once

#include <vug/field/field.h>
#include <vug/passages/sweep/segment.h>

#include <vector>

namespace vug::passages {

/// A range of segments, [first, last), next to a junction.
struct Arm {
  size_t first = 0;
  size_t last = 0;
};

/// Two arms, given by their indices, that meet with a fillet of this radius in metres.
struct Joint {
  size_t a = 0;
  size_t b = 0;
  double radius = 0;
};

struct Sweep {
  std::vector<Segment> segments;
  std::vector<Arm> arms;  ///< The two arms of a joint have no segment in common.
  std::vector<Joint> joints;
};

/// min over segments i of f_i and over joints of smin(min over arm a, min over arm b), with the
/// smooth minimum of field/blend.h: fillets exist only between passages that meet, so passages that
/// merely come close stay apart, and the order of the segments does not matter. The Lipschitz
/// constant is 1; values are at most the distance. Error(bad_input) without segments.
field::Field sweep(Sweep parts);

}  // namespace vug::passages
