// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <vug/base/error.h>
#include <vug/karst/contradictions.h>
#include <vug/network/network.h>

#include <algorithm>

namespace vug::karst {
namespace {

/// Key points may lie outside the rock by this distance in metres: sinks lie on its surface.
constexpr double kOnSurface = 10;
/// A sink and a spring that are closer are the same place.
constexpr double kSamePlace = 1;

std::string text(const Vec3d& p) { return fmt::format("({:g}, {:g}, {:g})", p.x, p.y, p.z); }

[[noreturn]] void fail(const std::string& message, const std::string& hint) {
  throw Error(ErrorCode::bad_input, message, {}, hint);
}

void require_in_rock(const Vec3d& p, const std::string& what, const Geology& g) {
  const Box3d& box = g.bounds;
  if (!grown(box, kOnSurface).intersects(p))
    fail(fmt::format("{} at {} is outside the rock, which reaches from {} to {}", what, text(p),
                     text(box.min), text(box.max)),
         "move it, or extend the rock with 'from' and 'to'");
  if (g.solid && g.solid->value(p) > kOnSurface)
    fail(fmt::format("{} at {} is outside the solid 'rock'", what, text(p)),
         "move it into the rock or onto its surface");
}

void require_name(const std::string& name, const char* what) {
  if (!network::is_station_name(name))  // Unnamed ones have got a name.
    fail(fmt::format("the name '{}' of a {} contains a blank", name, what),
         "names of stations have no blanks: use '_' instead");
}

}  // namespace

void require_no_contradiction(const KeyPoints& keys, const Rock& rock) {
  const Geology& g = rock.geology();
  for (const Sink& sink : keys.sinks) {
    require_name(sink.name, "sink");
    require_in_rock(sink.position, fmt::format("the sink '{}'", sink.name), g);
  }
  for (const Spring& spring : keys.springs) {
    require_name(spring.name, "spring");
    require_in_rock(spring.position, fmt::format("the spring '{}'", spring.name), g);
  }
  for (const Vec3d& p : keys.entrances) require_in_rock(p, "an entrance", g);
  for (const Vec3d& p : keys.waypoints) require_in_rock(p, "a waypoint", g);
  if (keys.springs.empty()) return;
  const auto lower = [](const Spring& a, const Spring& b) { return a.position.y < b.position.y; };
  const Spring& lowest = *std::min_element(keys.springs.begin(), keys.springs.end(), lower);
  for (const Sink& sink : keys.sinks) {
    if (sink.position.y < lowest.position.y)
      fail(fmt::format("the sink '{}' at the height {:g} m lies below all springs, the lowest of "
                       "which is '{}' at {:g} m",
                       sink.name, sink.position.y, lowest.name, lowest.position.y),
           "water flows down: exchange sink and spring, or change their heights (y)");
    for (const Spring& spring : keys.springs)
      if ((spring.position - sink.position).length() < kSamePlace)
        fail(fmt::format("the sink '{}' and the spring '{}' are in the same place", sink.name,
                         spring.name),
             "move one of them: the cave leads from sinks to springs");
  }
}

}  // namespace vug::karst
