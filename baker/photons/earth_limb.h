// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "photons/limb_table.h"

namespace coppermoon::photons {

/// Number of parts in an atmosphere's limb (WholeLimb): one for each belt, one or two for each other column in use.
std::size_t parts_of_limb(const atmosphere::Atmosphere& atmosphere);

/// Limb of the Earth in parts, each with a table of rays. A belt is one part, with the ground's radius at the belt;
/// any other column is one part on a sphere, and two on an ellipsoid, at the equator and at the pole. Columns with no
/// weight anywhere on the limb have no part. Between equator and pole,
/// light is the weighted mean of both parts, the pole's weight being cos² of the position angle.
class WholeLimb {
 public:
  struct Part {
    double radius_m;        ///< of the ground at the limb
    std::vector<Fan> fans;  ///< by wavelength; empty with Fans::when_asked
    double curvature_radius_m;
    atmosphere::Column column{};
    std::size_t column_index = 0;  ///< index in Atmosphere::columns()
  };
  struct Share {
    std::size_t part;
    double share;
  };
  /// Fourier series Σ cosine[m] cos mψ + sine[m] sin mψ, with ψ the position angle.
  struct Series {
    std::vector<double> cosine, sine;
  };

  /// When fans are made: all in the constructor, or each by a call of `fan`, as fans for hundreds of wavelengths would
  /// fill the memory.
  enum class Fans { made, when_asked };

  /// Given  optics  of each wavelength
  ///        rays    number of rays in each fan
  WholeLimb(const atmosphere::Atmosphere& atmosphere, std::span<const atmosphere::Optics> optics,
            int rays, Fans fans = Fans::made);

  const std::vector<Part>& parts() const { return parts_; }

  /// Fan of rays for one part at one wavelength.
  ///
  /// Given  optics  with a refractivity between those for which the limb was made
  ///        air     the limb's, or one that differs only in amounts (LimbTable::fan)
  Fan fan(std::size_t part, const atmosphere::Optics& optics,
          const atmosphere::Atmosphere& air) const {
    return tables_[part].fan(optics, *air.columns()[parts_[part].column_index]);
  }

  /// Parts of the limb at a position angle, with weights that add up to 1. The second weight is 0 where one part
  /// suffices.
  ///
  /// Accuracy  on an ellipsoid the pole's share is taken as cos² of the position angle: 0.3 % of the
  ///           difference between pole and equator
  std::array<Share, 2> at(double position_angle_rad) const;

  /// Weight of each part as a Fourier series in the position angle.
  ///
  /// Given     highest  highest harmonic wanted, 0 or more
  /// Returned  by part, all of the same length: up to the last harmonic that is nonzero in any part
  /// Accuracy  1e-12; smaller coefficients are set to 0
  std::vector<Series> series(int highest) const;

 private:
  atmosphere::Atmosphere atmosphere_;
  std::vector<Part> parts_;
  std::vector<LimbTable> tables_;  ///< of each part, with Fans::when_asked
  std::vector<std::size_t>
      part_of_column_;  ///< each column's first part; arbitrary for a column not in use
};

}  // namespace coppermoon::photons
