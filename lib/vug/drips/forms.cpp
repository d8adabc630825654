// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/rng.h>
#include <vug/drips/chemistry.h>
#include <vug/drips/drop.h>
#include <vug/drips/forms.h>
#include <vug/drips/growth.h>

#include <algorithm>
#include <cmath>

namespace vug::drips {
namespace {

/// Least lengths in radii of the tip, of hanging and of standing forms.
constexpr double kLeastHanging = 6, kLeastStanding = 1.5;
/// The share of the gap that a stalactite takes at most without a stalagmite below it.
constexpr double kMostHanging = 0.8;
/// Under drops that follow faster than the first time in seconds, the apex is a cone, whose cosine
/// falls to the last number under the fastest.
constexpr double kCandle = 20, kFastestDrip = 2, kSteepest = 0.75;
constexpr double kThickestTrunk = 0.155;  // Of stalagmites, metres.
constexpr double kLeastWaist = 0.4, kMostWaist = 0.65;
constexpr double kCoat = 0.15, kCoatYears = 12000;
/// The foot of a stalagmite is aside of its apex where the drip has moved, by an angle in radians
/// with this standard deviation and maximum, and downhill by this share of the floor's slope.
constexpr double kTrunkLean = 0.022, kMostTrunkLean = 0.05, kDownhill = 0.08;
/// The foot is aside by at most this number of radii, and this share of the height.
constexpr double kMostAside = 1.6, kMostTilt = 0.08;
/// On this share of the stumps an end has grown again, of up to that share of the lost length.
constexpr double kRegrown = 0.55, kMostRegrown = 0.5;
/// Ribs form at the wavelength of a film, 2.7 cm, of which 1 to 4 merge; trunks of this radius in
/// metres and height in radii have them.
constexpr double kFluteWave = 0.027, kFlutedRadius = 0.07, kFlutedHeight = 7;
constexpr int kFewestFlutes = 6, kMostFlutes = 20;
/// Both parts of a column meet aside of each other by this share of the radius at most.
constexpr double kOffset = 0.4;
/// Domes grow at the feet of stalagmites under drips faster than this in seconds; their scale in
/// radii of the trunk.
constexpr double kDomeInterval = 15, kDomeScale = 0.45;

/// The tangent of a slope's angle, at most 2.
double slope_tangent(const Vec3d& normal) {
  const double level = std::fabs(normal.y);
  return level > 0.45 ? std::sqrt(std::max(0.0, 1 - level * level)) / level : 2;
}

class Grower {
 public:
  Grower(const Graph& graph, const FormOptions& o)
      : graph_(graph), o_(o), curve_(common_curve(o.girth)) {}

  void grow(const Node& drop, const Node& landing, std::vector<Form>& out) const {
    RandomStream random(RandomKey(o_.seed).at("form").at(static_cast<uint64_t>(drop.id)));
    const bool chosen = random.uniform() < o_.stalagmites;
    const bool breaks = random.uniform() < o_.broken;
    const double break_at = random.uniform(0.2, 0.7);
    const double lean = std::clamp(kTrunkLean * random.normal(), -kMostTrunkLean, kMostTrunkLean);
    const double heading = random.uniform(0, kPi);
    const bool regrows = random.uniform() < kRegrown;
    const double regrown = kMostRegrown * random.uniform(), merged = random.uniform(1, 4);
    const double offset = kOffset * random.uniform();
    Form common;
    common.heading = 2 * heading;
    common.drip = drop.id;
    common.interval = graph_.interval(drop);
    common.age = drop.water.age;
    common.plane = drop.plane;
    const double gap = drop.position.y - landing.position.y;
    const bool stands = chosen && landing.growth > 0;
    if (stands && drop.growth + landing.growth >= gap) {
      Form form = column(common, drop, landing);
      form.flutes = flutes(form.radius + form.coat, merged);
      form.offset = offset * form.radius;
      out.push_back(form);
      return;
    }
    const double longest = stands ? gap - landing.growth : kMostHanging * gap;
    const double length = std::min(drop.growth, longest);
    if (length >= kLeastHanging * std::max(o_.tip, 0.5 * straw_diameter(drop.water.temperature))) {
      Form form = hanging(common, drop, length);
      if (breaks && form.kind == FormKind::stalactite) {
        form.broken = break_at;
        if (regrows) form.regrown = regrown * break_at * length;
      }
      out.push_back(form);
    }
    if (stands && landing.growth >= kLeastStanding * o_.tip) {
      Form form = standing(common, drop, landing);
      form.top = landing.position + Vec3d(0, landing.growth, 0);
      const double aside = landing.growth * maths::tan(lean);
      Vec3d foot(aside * maths::cos(heading), 0, aside * maths::sin(heading));
      foot += Vec3d(landing.normal.x, 0, landing.normal.z) * (kDownhill * landing.growth);
      const double most = std::min(kMostAside * form.radius, kMostTilt * landing.growth);
      if (foot.length() > most) foot *= most / foot.length();
      form.bottom += foot;
      form.root += foot.length() * slope_tangent(landing.normal);
      if (form.radius >= kFlutedRadius && landing.growth > kFlutedHeight * form.radius)
        form.flutes = flutes(form.radius, merged);
      if (form.interval < kDomeInterval)
        form.dome = kDomeScale * form.radius * (1 - form.interval / kDomeInterval);
      out.push_back(form);
    }
  }

 private:
  static int flutes(double radius, double merged) {
    const auto ribs = static_cast<int>(2 * kPi * radius / (kFluteWave * merged));
    return std::clamp(ribs, kFewestFlutes, kMostFlutes);
  }

  Form hanging(Form form, const Node& drop, double length) const {
    const double straw = 0.5 * straw_diameter(drop.water.temperature);
    form.kind = drop.straw && o_.tip <= 2 * straw ? FormKind::straw : FormKind::stalactite;
    form.radius = form.kind == FormKind::straw
                      ? std::max(o_.tip, straw)
                      : root_radius(curve_, length, std::max(o_.tip, straw));
    form.root = form.radius * slope_tangent(drop.normal) + o_.tip;
    form.top = drop.position;
    const Vec3d axis = drop.tip - drop.position;
    form.bottom = drop.position + axis * (length / axis.length());
    return form;
  }

  Form standing(Form form, const Node& drop, const Node& landing) const {
    form.kind = FormKind::stalagmite;
    const double trunk =
        std::min(kThickestTrunk, trunk_radius(graph_.drop, drop.water.temperature, form.interval));
    form.scatter = landing.scatter;
    form.radius = std::max(std::sqrt(trunk * trunk + form.scatter * form.scatter), 1.2 * o_.tip);
    const double hurry = std::clamp((kCandle - form.interval) / (kCandle - kFastestDrip), 0.0, 1.0);
    form.apex_cosine = 1 - hurry * (1 - kSteepest);
    form.bottom = landing.position;
    form.root = 2 * form.radius * slope_tangent(landing.normal) + o_.tip;
    return form;
  }

  /// A film of calcite covers both since they met.
  Form column(const Form& common, const Node& drop, const Node& landing) const {
    Form form = standing(common, drop, landing);
    form.kind = FormKind::column;
    const double together = drop.growth + landing.growth;
    const double gap = drop.position.y - landing.position.y;
    form.top = drop.position;
    form.waist = std::clamp(landing.growth / together, kLeastWaist, kMostWaist);
    const double years = form.age * (1 - gap / together);
    form.coat = kCoat * (1 - maths::exp(-years / kCoatYears));
    form.root = 2 * (form.radius + form.coat) *
                    std::max(slope_tangent(landing.normal), slope_tangent(drop.normal)) +
                o_.tip;
    return form;
  }

  const Graph& graph_;
  const FormOptions& o_;
  field::StalactiteCurve curve_;
};

}  // namespace

std::vector<Form> forms_of(const Graph& graph, const FormOptions& options) {
  std::vector<Form> forms;
  const Grower grower(graph, options);
  for (const Edge& edge : graph.edges)
    if (edge.kind == EdgeKind::fall)
      grower.grow(graph.nodes[static_cast<size_t>(edge.from)],
                  graph.nodes[static_cast<size_t>(edge.to)], forms);
  std::stable_sort(forms.begin(), forms.end(),
                   [](const Form& a, const Form& b) { return a.drip < b.drip; });
  return forms;
}

}  // namespace vug::drips
