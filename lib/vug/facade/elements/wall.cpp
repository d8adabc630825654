// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/blocks.h>
#include <vug/field/boolean.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::facade {
namespace {

constexpr double kMostJoints = 20000;

struct Wall {
  double relief = 0;
  double course = 0;
  double block_length = 0;
  double joint = 0.02;
  double joint_depth = 0.03;

  static void describe(Schema<Wall>& s) {
    const auto length = [](std::string doc) {
      return ParamSpec{.doc = std::move(doc), .dimension = Dimension::length, .min = 0};
    };
    s.doc("Plain wall, raised or sunk, optionally with joints between courses of blocks.")
        .param("relief", &Wall::relief, any_length("projection of the surface; negative: sunk"))
        .param("course", &Wall::course, length("height of a course of blocks; 0: no joints"))
        .param("block", &Wall::block_length,
               length("length of a block; 0: joints between courses only"))
        .param("joint", &Wall::joint, positive_length("width of the joints"))
        .param("joint_depth", &Wall::joint_depth, positive_length("depth of the joints"));
  }

  Solids solids(double width, double height) const {
    Solids out;
    const Rect all{0, 0, width, height};
    if (relief < 0) out.cut.push_back(block(all, relief, kCutMargin));
    std::vector<field::Field> joints;
    if (course > 0) {
      const int courses = std::max(1, static_cast<int>(std::lround(height / course)));
      const int blocks =
          block_length > 0 ? std::max(1, static_cast<int>(std::lround(width / block_length))) : 0;
      if (static_cast<double>(courses) * (blocks + 1.0) > kMostJoints)
        throw Error(ErrorCode::too_large,
                    fmt::format("too many joints of a wall: {:.3g}", courses * (blocks + 1.0)));
      const double tall = height / courses, deep = std::max(relief, 0.0) - joint_depth;
      const double front = std::max(relief, 0.0) + kCutMargin;
      for (int i = 0; i < courses; ++i) {
        if (i > 0) joints.push_back(block({0, i * tall - joint / 2, width, joint}, deep, front));
        // Every other course is shifted by half a block.
        for (int j = 0; j <= blocks && blocks > 0; ++j) {
          const double x = (j + 0.5 * (i % 2)) * width / blocks;
          if (x > joint && x < width - joint)
            joints.push_back(block({x - joint / 2, i * tall, joint, tall}, deep, front));
        }
      }
    }
    if (relief > 0)
      out.add.push_back(field::subtract(block(all, -0.05, relief, 0.005), std::move(joints)));
    else
      for (field::Field& each : joints) out.cut.push_back(std::move(each));
    return out;
  }
};

}  // namespace
}  // namespace vug::facade

VUG_ELEMENT_KIND(wall) { return element_kind<Wall>("wall"); }
