// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "algebra/grid.h"
#include "photons/earth_limb.h"
#include "photons/limb_darkening.h"
#include "shadow/disc_arcs.h"
#include "shadow/irradiance.h"
#include "shadow/landed_light.h"

namespace coppermoon::shadow {

/// Each part's share of the limb as a Fourier series in the position angle, and the angles at which light is wanted.
class Around {
 public:
  std::vector<photons::WholeLimb::Series> parts;
  algebra::Grid<double> turns;  ///< cos mθ at (angle, 2 m), sin mθ at (angle, 2 m + 1)

  /// Given  highest  highest harmonic in the expansion of the parts' shares
  Around(const photons::WholeLimb& limb, int highest, std::span<const double> angles_rad);

  /// Cosine or sine term of one harmonic, with its weight in each part of the limb; at least one weight is not 0.
  struct Harmonic {
    std::size_t harmonic, turn;   ///< order of the harmonic, and its column in `turns`
    std::vector<double> weights;  ///< one for each part of the limb
  };

  /// Terms of all harmonics of an order below `count`.
  std::span<const Harmonic> some(std::size_t count) const;

  std::size_t angles() const { return turns.rows(); }
  std::size_t harmonics() const { return parts[0].cosine.size(); }

  /// Whether the limb's western half mirrors its eastern half.
  bool is_mirrored() const;

  /// Whether a part of the limb reaches within half_arc_rad of an angle, or of the direction opposite to the angle.
  bool is_near(std::size_t part, std::size_t angle, double half_arc_rad) const;

 private:
  std::vector<double> angles_rad_;
  std::vector<Harmonic> harmonics_;  // sorted by the order of the harmonic
  // (part of the limb, position angle): number of tabulated angles before this one at which the part's weight is > 0
  algebra::Grid<int> here_;
};

/// A wavelength in one of several atmospheres.
struct Wave {
  atmosphere::Optics optics;
  const atmosphere::Atmosphere* air;  ///< may differ from the limb's only in amounts of absorbers
};

/// Light from the whole limb on one plane of the shadow.
///
/// Off the axis, light is computed for each position angle from the parts of the limb near that angle or the opposite
/// one, because no other parts send light there. A Fourier series in the position angle is used near the axis (where
/// all parts send light), in symmetric air, and in air that varies only with latitude if the series costs less.
class LandedPlane {
 public:
  /// Axis distance at which light is wanted, and where to write the light.
  struct Place {
    double gamma_m;           ///< axis distance
    std::span<double> ratio;  ///< [angle][wavelength], to which light is added
  };

  /// Inputs that all planes share. They must outlive the planes.
  struct Sunlit {
    const photons::WholeLimb& limb;  ///< makes fans of rays on demand
    const Around& around;
    const photons::DiscTerms& sun;
    std::span<const Wave> waves;
    const Arrangement& arrangement;
    double bin_m;       ///< width of the bins of axis distance in which light is gathered
    double farthest_m;  ///< largest axis distance of all places
  };

  LandedPlane(const Sunlit& sunlit, double depth_m);

  /// Whether the limb's light at all wavelengths fits into memory. If not, every call of `light` computes it again.
  bool keeps_light() const { return blocks_at_once() == blocks(); }

  /// Adds light to each place's `ratio`.
  ///
  /// Given  done  progress callback, called with the fraction of places completed since its last call
  void light(std::span<const Place> places, const std::function<void(double)>& done);

 private:
  using Block = std::array<double, lanes>;  // one value for each wavelength in the block

  /// Nodes of LandedLight from which a place receives light, and the factors by which their moments are multiplied.
  struct Draws {
    double gamma_m = 0;
    std::vector<int> nodes;
    algebra::Grid<double> factors;  ///< (harmonic, (node × terms + term) × moments + moment)
  };

  /// Light that landed on the plane, for consecutive blocks of wavelengths and for each part of the limb.
  struct Blocks {
    std::size_t first = 0, count = 0;
    std::vector<LandedLight> landed = {};  ///< [block × parts of the limb + part]
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
  int first_ = std::numeric_limits<int>::max(), last_ = -first_;  // bins in which light lands
  Blocks landed_;                                                 // all blocks, if keeps_light()
};

}  // namespace coppermoon::shadow
