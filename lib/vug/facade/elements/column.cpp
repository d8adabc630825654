// SPDX-License-Identifier: Apache-2.0
// A column: a shaft with entasis between base and capital. Proportions are relative to the
// diameter, as in the classical orders.
#include <vug/base/maths.h>
#include <vug/facade/blocks.h>
#include <vug/facade/outline.h>
#include <vug/field/affine.h>
#include <vug/field/boolean.h>
#include <vug/field/registry.h>

#include <algorithm>

namespace vug::facade {
namespace {

enum class Order { plain, doric, ringed };

struct Column {
  double diameter = 0;
  Order order = Order::doric;
  double base = 0.4;
  double capital = 0.5;
  double taper = 0.16;
  int flutes = 0;
  double set_back = 0;

  static void describe(Schema<Column>& s) {
    s.doc("A round column in the middle of its rectangle, over the whole height.")
        .param("diameter", &Column::diameter,
               {.doc = "diameter at the foot of the shaft; 0: two thirds of the width",
                .dimension = Dimension::length,
                .min = 0})
        .choice("order", &Column::order,
                {{"plain", Order::plain}, {"doric", Order::doric}, {"ringed", Order::ringed}},
                "plain: blocks at both ends; doric: a cushion under a block; ringed: three rings")
        .param("base", &Column::base, {.doc = "height in diameters; 0: none", .min = 0, .max = 3})
        .param("capital", &Column::capital,
               {.doc = "height in diameters; 0: none", .min = 0, .max = 3})
        .param("taper", &Column::taper,
               {.doc = "relative reduction of the diameter at the top", .min = 0, .max = 0.6})
        .param("flutes", &Column::flutes,
               {.doc = "number of flutes around the shaft", .min = 0, .max = 64})
        .param("set_back", &Column::set_back,
               any_length("distance of the axis behind the face; negative: in front of it"));
  }

  /// Radius of the shaft at a fraction of its height: constant for a third, then curved.
  double radius(double at, double foot) const {
    const double t = std::max(0.0, (at - 0.25) / 0.75);
    return foot * (1 - taper * t * t * (1.6 - 0.6 * t));
  }

  Outline shaft(double foot, double low, double high) const {
    Outline out{{0, low}};
    constexpr int kSteps = 8;
    for (int i = 0; i <= kSteps; ++i) {
      const double at = static_cast<double>(i) / kSteps;
      out.push_back({radius(at, foot), low + (high - low) * at});
    }
    out.push_back({0, high});
    return out;
  }

  Solids solids(double width, double height) const {
    const double across = diameter > 0 ? diameter : width * 2 / 3;
    const double foot = across / 2, low = base * across, high = height - capital * across;
    if (!(high - low > 0.2 * across))
      throw Error(ErrorCode::bad_input, "the base and the capital leave no space for the shaft");
    const double top = radius(1, foot), plinth = low / 2;
    std::vector<field::Field> parts;
    const auto square = [&](double half, double from, double to) {
      parts.push_back(field::transformed(
          block({-half, from, 2 * half, to - from}, -half, half, 0.02 * across), Transform()));
    };
    field::Field round = revolved(shaft(foot, low - 0.02, high + 0.02));
    if (flutes > 0) {
      const double hollow = 0.75 * kPi * foot / flutes;
      field::Field one = field::transformed(
          field::make("capsule",
                      {{"radius", hollow},
                       {"a", Value::Vector{{0, low + 2.5 * hollow, 0}, Dimension::length}},
                       {"b", Value::Vector{{0, high - 2.5 * hollow, 0}, Dimension::length}}}),
          Transform::translation({foot + 0.35 * hollow, 0, 0}));
      round = field::subtract(
          round,
          {field::make("polar_repeat", {{"field", field::as_value(one)}, {"count", flutes}})});
    }
    parts.push_back(round);
    if (base > 0) {
      square(1.3 * foot, 0, plinth);
      Outline torus{{0, plinth - 0.01}};
      for (const Vec2d& p :
           arc({1.05 * foot, 0.5 * (plinth + low)}, 0.5 * (low - plinth), -kPi / 2, kPi / 2, 10))
        torus.push_back(p);
      torus.push_back({0, low + 0.005});
      parts.push_back(revolved(torus));
    }
    if (capital > 0) add_capital(parts, square, top, high, height);
    Solids out;
    out.add.push_back(field::transformed(field::unite(std::move(parts)),
                                         Transform::translation({width / 2, 0, -set_back})));
    return out;
  }

  template <class Square>
  void add_capital(std::vector<field::Field>& parts, const Square& square, double top, double high,
                   double height) const {
    const double tall = height - high, abacus = height - 0.35 * tall, wide = 1.35;
    if (order == Order::plain) return square(wide * top, high, height);
    square(1.05 * wide * top, abacus, height);
    Outline echinus{{0, high - 0.01}};
    if (order == Order::ringed)
      for (int i = 0; i < 3; ++i) {
        const double step = (abacus - high) / 3;
        for (const Vec2d& p :
             arc({top * (1 + 0.08 * i), high + (i + 0.5) * step}, step / 2, -kPi / 2, kPi / 2, 6))
          echinus.push_back(p);
      }
    else
      for (int i = 0; i <= 8; ++i) {
        const double t = i / 8.0;
        echinus.push_back(
            {top * (1 + (wide - 1) * maths::sin(t * kPi / 2)), high + (abacus - high) * t});
      }
    echinus.push_back({0, abacus + 0.005});
    parts.push_back(revolved(echinus));
  }
};

}  // namespace
}  // namespace vug::facade

VUG_ELEMENT_KIND(column) { return element_kind<Column>("column"); }
