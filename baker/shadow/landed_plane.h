// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
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
class Around {
 public:
  std::vector<photons::WholeLimb::Series> parts;
  algebra::Grid<double> turns;  ///< (angle, 2 m and 2 m + 1) cos mθ and sin mθ

  /// Given  highest  harmonic of the parts' shares
  Around(const photons::WholeLimb& limb, int highest, std::span<const double> angles_rad);

  /// The cosines, or the sines, of one harmonic, that some part has.
  struct Harmonic {
    std::size_t harmonic, turn;   ///< turn: its column of turns
    std::vector<double> weights;  ///< by part
  };

  /// Terms of so many harmonics from 0 on.
  std::span<const Harmonic> some(std::size_t count) const;

  std::size_t angles() const { return turns.rows(); }
  std::size_t harmonics() const { return parts[0].cosine.size(); }

  /// Whether west of the axis all parts are as east of it.
  bool is_mirrored() const;

  /// Whether a part has any of the limb that is as near as this to one of the angles, or to the
  /// opposite one.
  bool is_near(std::size_t part, std::size_t angle, double half_arc_rad) const;

 private:
  std::vector<double> angles_rad_;
  std::vector<Harmonic> harmonics_;  // in order
  algebra::Grid<int> here_;          // (part, direction) how many of those up to it have some of it
};

/// A wavelength, in some air.
struct Wave {
  atmosphere::Optics optics;
  const atmosphere::Atmosphere* air;  ///< as WholeLimb::fan has it
};

/// Light on one plane, of the whole limb.
///
/// Off the axis each angle has its own: of the parts of the limb that the Sun's disc covers as seen
/// from there, for no other sends any. Near the axis, where it covers all of them, of air alike all
/// around, and of belts at many angles it is a series in the position angle.
class LandedPlane {
 public:
  /// Where light is asked for, and where it is written.
  struct Place {
    double gamma_m;           ///< axis distance
    std::span<double> ratio;  ///< [angle][wavelength]
  };

  /// Everything that all planes share, and that outlives them.
  struct Sunlit {
    const photons::WholeLimb& limb;  ///< fans are made when asked
    const Around& around;
    const photons::DiscTerms& sun;
    std::span<const Wave> waves;
    const Arrangement& arrangement;
    double bin_m;       ///< width of the bins that light is gathered in, of distance from the axis
    double farthest_m;  ///< of all places, from the axis
  };

  LandedPlane(const Sunlit& sunlit, double depth_m);

  /// Whether the limb's light of all wavelengths fits into memory; else it is made anew each time.
  bool keeps_light() const { return blocks_at_once() == blocks(); }

  /// Adds each place's light to its rows.
  ///
  /// Given  done  is told how many places more are through, as a part of all
  void light(std::span<const Place> places, const std::function<void(double)>& done);

 private:
  using Block = std::array<double, lanes>;  // one value a wavelength

  /// Nodes that a place draws light from, and their factors.
  struct Draws {
    double gamma_m = 0;
    std::vector<int> nodes;
    algebra::Grid<double> factors;  ///< (harmonic, ((node, term), moment))
  };

  /// Light of some blocks of wavelengths, by the limb's part.
  struct Blocks {
    std::size_t first = 0, count = 0;
    std::vector<LandedLight> landed = {};  ///< block by block
  };

  std::size_t blocks() const { return (sunlit_.waves.size() + lanes - 1) / lanes; }
  std::size_t blocks_at_once() const;
  Blocks landed(std::size_t first) const;
  bool by_series(double gamma_m) const;
  void add_light(std::span<const Place> places,
                 const std::function<void(std::size_t)>& pairs_done) const;
  void add_series(const Draws& draws, const Blocks& blocks, std::size_t block,
                  std::span<double> ratio) const;
  void add_angles(const Draws& draws, const Blocks& blocks, std::size_t first_angle,
                  std::span<double> ratio) const;
  double seen(std::size_t term, std::size_t wave) const;
  Draws draws(double gamma_m) const;
  static void collect(const Stretch& stretch, bool across, std::size_t node, Draws& all);

  Sunlit sunlit_;
  LandingPlane plane_;
  double a_, factor_;
  int first_ = std::numeric_limits<int>::max(), last_ = -first_;  // bins that light lands in
  Blocks landed_;                                                 // some, or where it is kept all
};

}  // namespace coppermoon::shadow
