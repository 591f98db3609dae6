// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "photons/limb_table.h"

namespace coppermoon::photons {

std::size_t parts_of_limb(const atmosphere::Atmosphere& atmosphere);

/// The Earth's limb, divided into parts that each have a table of rays. Each belt of air is one part, with the
/// ground's radius at the belt. Any other column is one part if the Earth is a sphere. On an ellipsoid it has two
/// parts, for the equator and for the pole. Light at a position angle is then the mean of these two, weighted by sin²
/// and cos² of the angle. Columns that do not occur on the limb have no part.
class WholeLimb {
 public:
  struct Part {
    double radius_m;        ///< radius of the ground at the limb
    std::vector<Fan> fans;  ///< one for each wavelength; empty with Fans::when_asked
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

  /// Whether the constructor makes all fans of rays, or `fan` makes each of them when called. The latter saves memory,
  /// because fans for hundreds of wavelengths are large.
  enum class Fans { made, when_asked };

  /// Given  optics  optical properties at each wavelength
  ///        rays    number of rays in each fan
  WholeLimb(const atmosphere::Atmosphere& atmosphere, std::span<const atmosphere::Optics> optics,
            int rays, Fans fans = Fans::made);

  const std::vector<Part>& parts() const { return parts_; }

  /// Fan of rays through one part of the limb, at one wavelength.
  ///
  /// Given  optics  its refractivity must be within the range of those passed to the constructor
  ///        air     the limb's atmosphere, or one that differs only in amounts of absorbers (see LimbTable::fan)
  Fan fan(std::size_t part, const atmosphere::Optics& optics,
          const atmosphere::Atmosphere& air) const {
    return tables_[part].fan(optics, *air.columns()[parts_[part].column_index]);
  }

  /// Parts of the limb at a position angle, with weights that add up to 1. The second weight is 0 if one part suffices.
  ///
  /// Accuracy  0.3 % of the difference between pole and equator, because an ellipsoid's pole is weighted by cos² of the
  ///           position angle
  std::array<Share, 2> at(double position_angle_rad) const;

  /// Weight of each part of the limb as a Fourier series in the position angle.
  ///
  /// Given     highest  highest harmonic wanted, 0 or more
  /// Returned  one series for each part, all up to the highest harmonic that is nonzero in any part
  /// Accuracy  1e-12; smaller coefficients are set to 0
  std::vector<Series> series(int highest) const;

 private:
  atmosphere::Atmosphere atmosphere_;
  std::vector<Part> parts_;
  std::vector<LimbTable> tables_;  ///< one for each part with Fans::when_asked, otherwise none
  std::vector<std::size_t>
      part_of_column_;  ///< index of each column's first part; arbitrary for columns not in use
};

}  // namespace coppermoon::photons
