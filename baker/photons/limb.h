// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "photons/limb_table.h"
#include "photons/trace.h"

namespace coppermoon::photons {

/// The whole limb in parts that one table each stands for: every column of air; on an ellipsoid
/// each at the equator and at the pole; between them a place takes cos² of its position angle of the
/// pole's.
class WholeLimb {
 public:
  struct Part {
    double radius_m;        ///< of the limb's ground
    std::vector<Fan> fans;  ///< by wavelength
    double curvature_radius_m;
    atmosphere::Column column{};
  };
  struct Share {
    std::size_t part;
    double share;
  };

  /// Given  optics  of each wavelength;  rays: of each fan
  WholeLimb(const atmosphere::Atmosphere& atmosphere, std::span<const atmosphere::Optics> optics,
            int rays);

  const std::vector<Part>& parts() const { return parts_; }

  /// What makes up the limb at a position angle; shares add to 1, the second is 0 on a sphere.
  std::array<Share, 2> at(double position_angle_rad) const;

  /// Position angles where one column of air ends and another begins.
  const std::vector<double>& borders_rad() const { return borders_rad_; }

  /// How much of an arc of the limb each part makes up [rad], by part.
  ///
  /// Accuracy  on an ellipsoid the pole's share is taken as cos² of the position angle: 0.3 % of the
  ///           difference between pole and equator
  void arc(double middle_rad, double half_width_rad, std::span<double> lengths) const;

  /// A ray through the air by the table of its wavelength, in the plane through the Earth's centre.
  ///
  /// Returned  the ray that left, steps 0; nothing when it met the ground, or passed above the air
  /// Accuracy  of 500 rays, against limb_ray: 2e-3 of optical depth and 2e-3, of bending and 5e-7 rad
  std::optional<Traced> passed(const Ray& ray, std::size_t wavelength) const;

 private:
  /// From one position angle to the next where the air changes, around the whole limb.
  struct Stretch {
    double from_rad, to_rad;
    std::size_t column;
  };

  void find_stretches();

  atmosphere::Atmosphere atmosphere_;
  std::vector<Part> parts_;
  std::vector<Stretch> stretches_;
  std::vector<double> borders_rad_;
};

}  // namespace coppermoon::photons
