// SPDX-License-Identifier: Apache-2.0
// For any word, including unmatched brackets, huge numbers and NaN: the turtle rejects it as bad
// input or draws finite axes with orthogonal frames, whose stems have a finite surface.
#include "require.h"
#include "target.h"

#include <vug/base/error.h>
#include <vug/flora/sweep_mesh.h>
#include <vug/lsystem/turtle.h>

#include <cmath>
#include <cstring>

namespace {

using namespace vug;

/// Reads numbers from the bytes in order: many common values, and the value of any eight bytes.
class Numbers {
 public:
  Numbers(const uint8_t* data, size_t size) : at_(data), end_(data + size) {}

  bool empty() const { return at_ == end_; }
  uint8_t byte() { return empty() ? uint8_t{0} : *at_++; }
  double number() {
    constexpr double kOften[] = {0,
                                 1,
                                 -1,
                                 0.5,
                                 0.1,
                                 3,
                                 1e-9,
                                 1e9,
                                 1e30,
                                 -1e30,
                                 1e-320,
                                 1e308,
                                 -1e308,
                                 1.5707963267948966,
                                 3.141592653589793};
    const uint8_t which = byte();
    if (which < std::size(kOften)) return kOften[which];
    if (which < 200) return (which - 100) / 16.0;
    uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) bits = bits << 8 | byte();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }

 private:
  const uint8_t* at_;
  const uint8_t* end_;
};

bool finite(const Vec3d& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool square(const vug::Frame& frame) {
  const auto unit = [](const Vec3d& v) { return std::fabs(v.length() - 1) < 1e-6; };
  return unit(frame.tangent) && unit(frame.normal) && unit(frame.binormal) &&
         (frame.tangent.cross(frame.normal) - frame.binormal).length() < 1e-6;
}

void check(const lsystem::Drawing& drawing) {
  for (size_t i = 0; i < drawing.axes.size(); ++i) {
    const lsystem::Axis& axis = drawing.axes[i];
    require(axis.parent == lsystem::Axis::kNone || axis.parent < i, "parents come first");
    require(!axis.stations.empty(), "an axis has a station");
    double along = 0;
    for (const lsystem::Station& station : axis.stations) {
      require(finite(station.position) && square(station.frame), "stations are somewhere");
      require(station.radius >= 0 && std::isfinite(station.radius), "radii are numbers");
      require(station.along >= along, "stations follow one another");
      along = station.along;
    }
    for (const lsystem::Node& node : axis.nodes)
      require(node.along >= 0 && node.along <= along, "nodes lie on their axis");
  }
  for (const lsystem::Polygon& polygon : drawing.polygons) {
    require(polygon.corners.size() >= 3, "polygons have corners");
    for (const Vec3d& corner : polygon.corners) require(finite(corner), "corners are somewhere");
  }
  for (const lsystem::Instance& one : drawing.instances)
    require(finite(one.position) && square(one.frame) && std::isfinite(one.size),
            "things are somewhere");
}

void sweep(const lsystem::Drawing& drawing, const flora::SweepOptions& options) {
  const std::vector<flora::Tube> tubes = flora::tubes(drawing, options);
  const mesh::Mesh mesh = flora::swept_mesh(tubes);
  for (const auto& p : mesh.positions)
    require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "stems are somewhere");
  for (const flora::Tube& tube : tubes) {
    require(std::isfinite(tube.slope()) && tube.slope() >= 1, "slopes are bounds");
    const Box3d box = tube.bounds();
    require(finite(box.min) && finite(box.max), "stems have bounds");
  }
}

lsystem::TurtleOptions options_of(Numbers& numbers) {
  lsystem::TurtleOptions options;
  options.angle = numbers.number();
  options.step = numbers.number();
  options.width = numbers.number();
  options.thinner = numbers.number();
  options.elasticity = numbers.number();
  options.tropism = {numbers.number(), numbers.number(), numbers.number()};
  options.guides = {{{Vec3d(0), Vec3d(0, 1, 0), Vec3d(1, 1, 0), Vec3d(2, 1, 1)}}};
  options.instances = {"Leaf"};
  return options;
}

}  // namespace

VUG_FUZZ_TARGET(turtle) {
  if (size > 2000) return;
  Numbers numbers(data, size);
  const lsystem::TurtleOptions options = options_of(numbers);
  flora::SweepOptions sweeping;
  sweeping.wall = numbers.byte() % 2 ? 0.2 : 0;
  sweeping.open = numbers.byte() % 2;
  lsystem::Alphabet alphabet;
  lsystem::Word word;
  const std::vector<lsystem::TurtleCommand>& commands = lsystem::turtle_commands();
  while (!numbers.empty()) {
    const size_t which = numbers.byte() % (commands.size() + 1);
    const bool thing = which == commands.size();
    const size_t most = thing ? 3 : commands[which].most;
    std::vector<double> parameters;
    for (size_t count = numbers.byte() % (most + 1); count > 0; --count)
      parameters.push_back(numbers.number());
    if (!thing && parameters.size() < commands[which].least) continue;
    word.append(alphabet.add(thing ? "Leaf" : commands[which].name, parameters.size()), parameters);
  }
  if (word.empty()) return;
  try {
    const lsystem::Drawing drawing = lsystem::draw(word, alphabet, options);
    check(drawing);
    require(drawing == lsystem::draw(word, alphabet, options), "a drawing is the same each time");
    sweep(drawing, sweeping);
  } catch (const Error& error) {
    require(error.code() == ErrorCode::bad_input || error.code() == ErrorCode::too_large,
            "errors blame the word");
  }
}
