// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "algebra/described.h"
#include "algebra/grid.h"
#include "algebra/progress.h"
#include "uses/light/moonlight.h"

namespace coppermoon::uses {

/// A plane across the shadow, with the air and the Sun.
struct ShadowCut {
  atmosphere::Atmosphere air;
  shadow::Arrangement arrangement;  ///< with only one plane
};

/// The plane through the Moon's centre at one moment. Its air lacks the terms that the request leaves out.
ShadowCut shadow_at_the_moon(const LightRequest& request, const almanac::SkyState& sky);

/// Places and wavelengths at which a profile is computed.
struct ProfilePlaces {
  std::vector<double> wavelengths_nm{450, 550, 650};  ///< 380 to 780
  std::vector<double> axis_distances_m{};  ///< increasing; if empty, every 100 km across the shadow
  /// Angle about the axis, from celestial north through east, 0 to 360. If absent, the mean over all angles is used.
  std::optional<double> position_angle_deg{};
};

/// Ratio of irradiance to unobstructed sunlight across the shadow, and the ratio's standard error, both indexed by
/// (axis distance, wavelength). Refracted, scattered and direct light are included.
struct ShadowProfile {
  std::vector<double> wavelengths_nm, axis_distances_m;
  algebra::Grid<double> ratio, standard_error;
};

template <class Field>
void describe(Field&& is, const ShadowProfile& profile) {
  is.a("ShadowProfile", "Light across the Earth's shadow, over unobstructed sunlight.");
  is("wavelengths_nm", profile.wavelengths_nm, algebra::unit::nanometres,
     "wavelengths, shape (W,)");
  is(
      "axis_distance_km",
      [&] {
        auto distances = profile.axis_distances_m;
        for (double& distance : distances) distance /= 1e3;
        return distances;
      },
      algebra::unit::kilometres, "distances from the shadow's axis, shape (D,)");
  is("irradiance_ratio", profile.ratio,
     "spectral irradiance over that of unobstructed sunlight, shape (D, W)");
  is("standard_error", profile.standard_error,
     "standard error of the ratio, of photons, shape (D, W)");
}

/// Throws  Error  when no wavelength is given, distances do not increase within 0 to 1e8 m, or refracted_light throws
ShadowProfile shadow_profile(const LightRequest& request, const ShadowCut& cut,
                             const ProfilePlaces& places = {},
                             const algebra::Progress& progress = {});

}  // namespace coppermoon::uses
