// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "photons/limb_table.h"

namespace coppermoon::photons {

/// How many parts the limb of some air has (WholeLimb): every belt is one, a column one or two.
std::size_t parts_of_limb(const atmosphere::Atmosphere& atmosphere);

/// The whole limb in parts, each with a table of rays: one part for every belt, where the limb is there;
/// for every other column of air one part, on an ellipsoid two, at the equator and at the pole. A place
/// between these is a mean of both parts, the pole's with a weight of cos² of the position angle.
class WholeLimb {
 public:
  struct Part {
    double radius_m;        ///< of the limb's ground
    std::vector<Fan> fans;  ///< by wavelength; none of a limb that makes them when asked
    double curvature_radius_m;
    atmosphere::Column column{};
    std::size_t column_index = 0;  ///< among the air's
  };
  struct Share {
    std::size_t part;
    double share;
  };
  /// Σ cosine[m] cos mψ + sine[m] sin mψ, with ψ the position angle.
  struct Series {
    std::vector<double> cosine, sine;
  };

  /// When the fans of rays are made: all at once, or each when it is asked for and by whoever asks, for
  /// fans of hundreds of wavelengths fill memory.
  enum class Fans { made, when_asked };

  /// Given  optics  of each wavelength;  rays: of each fan
  WholeLimb(const atmosphere::Atmosphere& atmosphere, std::span<const atmosphere::Optics> optics,
            int rays, Fans fans = Fans::made);

  const std::vector<Part>& parts() const { return parts_; }

  /// The fan of one part.
  ///
  /// Given  optics  within those the limb was made for
  ///        air     the limb's, or one that differs in amounts alone: LimbTable::fan
  Fan fan(std::size_t part, const atmosphere::Optics& optics,
          const atmosphere::Atmosphere& air) const {
    return tables_[part].fan(optics, *air.columns()[parts_[part].column_index]);
  }

  /// The parts that make up the limb at a position angle; their shares add to 1, the second is 0 where
  /// one part does.
  ///
  /// Accuracy  on an ellipsoid the pole's share is taken as cos² of the position angle: 0.3 % of the
  ///           difference between pole and equator
  std::array<Share, 2> at(double position_angle_rad) const;

  /// Each part's share as a series in the position angle.
  ///
  /// Given     highest  harmonic that is asked for, 0 or more
  /// Returned  by part, all equally long: up to the last harmonic that any of them has
  /// Accuracy  1e-12; coefficients smaller than that are 0
  std::vector<Series> series(int highest) const;

 private:
  atmosphere::Atmosphere atmosphere_;
  std::vector<Part> parts_;
  std::vector<LimbTable> tables_;        ///< of each part, where fans are made when asked
  std::vector<std::size_t> first_part_;  ///< of each column
};

}  // namespace coppermoon::photons
