// SPDX-License-Identifier: Apache-2.0
// The pieces of stalactites that broke: each lies within a step of the place below it, on its side.
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/base/rng.h>
#include <vug/drips/drop.h>
#include <vug/drips/forms.h>
#include <vug/drips/growth.h>
#include <vug/drips/surface.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace vug::drips {
namespace {

/// Pieces roll this far in metres.
constexpr double kRolled = 0.35;
/// Longer pieces broke when they fell; a piece is at least this number of its radii long.
constexpr double kLongestPiece = 0.8, kLeastSlender = 3;
/// Floors that are steeper by the cosine of their slope do not hold pieces.
constexpr double kHolding = 0.75;
/// The share of its radius that a piece keeps above the rock: the rest has sunk into sediment.
constexpr double kAbove = 0.8;
constexpr int kSettlings = 8, kContacts = 7;

class Floor {
 public:
  Floor(const field::Field& rock, const FormOptions& o)
      : rock_(rock), o_(o), curve_(common_curve(o.girth)) {}

  std::optional<Form> piece(const Form& stump, const Node& landing) const {
    const double straw = std::max(o_.tip, 0.5 * straw_diameter(10));
    Form out = stump;
    out.kind = FormKind::piece;
    out.regrown = out.broken = 0;
    const double length = (stump.top - stump.bottom).length();
    double lost = std::min(stump.broken * length, kLongestPiece);
    out.radius = root_radius(curve_, lost, straw);
    if (lost < kLeastSlender * out.radius) return std::nullopt;
    RandomStream random(RandomKey(o_.seed).at("piece").at(static_cast<uint64_t>(stump.drip)));
    const double way = random.uniform(0, 2 * kPi), away = kRolled * std::sqrt(random.uniform());
    const double heading = random.uniform(0, 2 * kPi);
    const Vec3d along(maths::cos(heading), 0, maths::sin(heading));
    const Vec3d middle =
        landing.position + Vec3d(away * maths::cos(way), 0, away * maths::sin(way));
    const auto tip = floor(middle - along * (0.5 * lost), landing.position.y);
    const auto end = floor(middle + along * (0.5 * lost), landing.position.y);
    if (!tip || !end) return std::nullopt;
    const Vec3d axis = (*end + Vec3d(0, out.radius, 0) - *tip - Vec3d(0, straw, 0)).normalized();
    out.bottom = *tip + Vec3d(0, straw, 0);
    out.top = out.bottom + axis * lost;
    return settled(out, straw);
  }

 private:
  std::optional<Vec3d> floor(const Vec3d& p, double near) const {
    const VerticalLine line(rock_, p, 0.05);
    if (line.solid(near + 0.3)) return std::nullopt;
    const auto y = line.crossing(near + 0.3, near - 0.5);
    if (!y || !(normal_at(rock_, {p.x, *y, p.z}).y > kHolding)) return std::nullopt;
    return Vec3d(p.x, *y, p.z);
  }

  /// Moves it up or down until it touches the rock.
  std::optional<Form> settled(Form form, double tip) const {
    for (int i = 0; i < kSettlings; ++i) {
      double gap = kInfinity;
      for (int k = 0; k < kContacts; ++k) {
        const double t = static_cast<double>(k) / (kContacts - 1);
        const double radius = tip + t * (form.radius - tip);
        const field::Gradient g = rock_.gradient(form.bottom + (form.top - form.bottom) * t);
        const double slope = std::max(g.gradient.length(), 0.3);
        gap = std::min(gap, g.value / slope - kAbove * radius);
      }
      if (std::fabs(gap) < 0.03 * form.radius) return form;
      form.bottom.y -= gap, form.top.y -= gap;
    }
    return std::nullopt;  // It would not lie still.
  }

  const field::Field& rock_;
  const FormOptions& o_;
  field::StalactiteCurve curve_;
};

}  // namespace

std::vector<Form> fallen_pieces(const field::Field& rock, const std::vector<Form>& forms,
                                const Graph& graph, const FormOptions& options) {
  std::map<int64_t, const Node*> landings;
  for (const Node& node : graph.nodes)
    if (node.kind == NodeKind::landing) landings.emplace(node.id, &node);
  const Floor ground(rock, options);
  std::vector<std::optional<Form>> found(forms.size());
  parallel_for(forms.size(), [&](size_t i) {
    const auto landing = landings.find(forms[i].drip);
    if (forms[i].broken > 0 && landing != landings.end())
      found[i] = ground.piece(forms[i], *landing->second);
  });
  std::vector<Form> out;
  for (const auto& piece : found)
    if (piece) out.push_back(*piece);
  return out;
}

}  // namespace vug::drips
