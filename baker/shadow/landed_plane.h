// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "algebra/grid.h"
#include "photons/limb.h"
#include "photons/limb_darkening.h"
#include "shadow/disc_arcs.h"
#include "shadow/irradiance.h"
#include "shadow/landed_light.h"

namespace coppermoon::shadow {

/// The limb's parts around the axis, and the position angles that light is asked for at.
struct Around {
  std::vector<photons::WholeLimb::Series> parts;
  algebra::Grid<double> turns;  ///< (angle, 2 m and 2 m + 1) cos mθ and sin mθ

  /// Given  highest  harmonic of the parts' shares
  Around(const photons::WholeLimb& limb, int highest, std::span<const double> angles_rad);

  std::size_t harmonics() const { return parts[0].cosine.size(); }
};

/// Light on one plane, of the whole limb: a series in the position angle for each axis distance.
class LandedPlane {
 public:
  /// Where light is asked for, and where it is written.
  struct Place {
    double gamma_m;           ///< axis distance
    std::span<double> ratio;  ///< [angle][wavelength]
  };

  /// Given  bin_m  width of the bins that light is gathered in, of distance from the axis
  LandedPlane(const photons::WholeLimb& limb, const Around& around, const photons::DiscTerms& sun,
              const Arrangement& arrangement, double depth_m, double bin_m);

  /// Adds each place's light to its rows.
  void light(std::span<const Place> places) const;

 private:
  using Block = std::array<double, lanes>;  // one value a wavelength
  using Harmonics = std::vector<double> photons::WholeLimb::Series::*;

  /// Sums that one term of the Sun's disc draws from the limb, of one harmonic.
  struct Draw {
    std::size_t term, harmonic;
    std::vector<NodeTerm> nodes;  ///< of the ring's
  };

  /// All that a ring draws.
  struct Draws {
    std::vector<int> nodes;
    std::vector<Draw> draws;  ///< harmonic by harmonic
  };

  void add_block(const Draws& ring, std::size_t first, std::span<double> ratio) const;
  bool gathered(std::span<const int> nodes, std::size_t block, std::size_t harmonic, Harmonics part,
                std::vector<double>& rows) const;
  void add_terms(std::span<const Draw> draws, std::span<const double> rows, std::size_t first,
                 Block& light) const;
  Draws draws(double gamma_m) const;
  static void collect(const Stretch& stretch, bool across, Draws& all);

  const Around& around_;
  const photons::DiscTerms& sun_;
  double bin_m_, a_, factor_;
  int first_ = std::numeric_limits<int>::max(), last_ = -first_;  // bins that light lands in
  std::vector<LandedLight> landed_;                               // by the limb's part
};

}  // namespace coppermoon::shadow
