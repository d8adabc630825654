// SPDX-License-Identifier: Apache-2.0
// The film of water on the cells of a pass: its sources, its way and its thickness.
#pragma once

#include <vug/base/schema.h>
#include <vug/cells/drainage.h>
#include <vug/cells/film.h>
#include <vug/cells/pass.h>

namespace vug::cells {

/// Parameters that rules with films share.
struct FilmParams {
  double rate = 0.1;        ///< Metres of water per day where the attribute `source` is 1.
  double condensation = 0;  ///< Metres of pure water per day, times the attribute `condensation`.
  double temperature = 10;  ///< Degrees Celsius.
  int gather = 4;           ///< See DrainageOptions.
  double head = 5e-4;       ///< See DrainageOptions.

  std::string fault() const {
    return rate + condensation > 0 ? "" : "no water: 'rate' or 'condensation' must be above 0";
  }
};

template <class P>
void describe_film(Schema<P>& s) {
  const auto depth = [](std::string doc) {
    return ParamSpec{.doc = std::move(doc), .dimension = Dimension::length, .min = 0};
  };
  s.param("rate", &P::rate, depth("depth of water that enters per day where `source` is 1"))
      .param("condensation", &P::condensation,
             depth("depth of pure water that condenses per day, times the attribute "
                   "`condensation` if there is one"))
      .param("temperature", &P::temperature,
             {.doc = "temperature of the water in degrees Celsius", .min = 0, .max = 30})
      .param("gather", &P::gather,
             {.doc = "exponent of steepness: 1 spreads over all lower neighbours, 8 takes the "
                     "steepest path",
              .min = 1,
              .max = 8})
      .param("head", &P::head,
             depth("height above the level of a pool up to which its crests overflow"));
}

/// A steady flow over the surface where it is now: at the positions of the cells, displaced by
/// `height` along the normal.
class FilmFlow {
 public:
  /// `calcium`: of the water of sources, mol/m3; condensed water contains none. Stores the outlets
  /// in the attribute `outlet` unless it exists. Throws Error(bad_input) if no water enters, or if
  /// it cannot leave.
  FilmFlow(Pass& pass, const FilmParams& params, double calcium = 0);

  const Drainage& drainage() const { return drainage_; }
  /// What enters at each cell.
  const std::vector<Load>& sources() const { return sources_; }

  /// The width in metres through which the water of a cell runs: the side of a square of its area.
  double width(uint32_t cell) const { return static_cast<double>(width_[cell]); }
  /// Thickness (metres) and mean speed (m/s) of the film for this discharge in m3/s.
  double thickness(uint32_t cell, double discharge) const;
  double speed(uint32_t cell, double discharge) const {
    return cube_root(static_cast<double>(speed_[cell]) * discharge * discharge);
  }

 private:
  double steepness(uint32_t cell) const;
  void set_speeds();

  const Network* network_;
  double viscosity_;
  std::vector<uint8_t> outlet_;
  Drainage drainage_;
  std::vector<Load> sources_;
  std::vector<float> width_;
  std::vector<float> speed_;  ///< For each cell, speed^3 / discharge^2.
};

/// Writes `discharge` (m3/s), `film` (thickness in metres; the depth of the water in pools) and
/// `pool` (depth in metres, 0 outside pools), given the loads after Drainage::route.
void write_film(Pass& pass, const FilmFlow& flow, const std::vector<Load>& load);

}  // namespace vug::cells
