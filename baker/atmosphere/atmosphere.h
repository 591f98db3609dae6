// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "algebra/quantity.h"
#include "atmosphere/aerosol.h"
#include "atmosphere/density.h"
#include "atmosphere/figure.h"
#include "atmosphere/ozone.h"
#include "atmosphere/seasonal_air.h"
#include "atmosphere/stratosphere.h"

namespace coppermoon::atmosphere {

/// Models of the air's density: no air; US Standard Atmosphere 1976, tapered to 0 at 42 km as by Yapo & Cutler (2009);
/// the same up to 86 km without a taper; air that depends on latitude and season (SeasonalAir), up to 86 km.
enum class Density { none, yapo_cutler, us_1976, seasonal };

/// How ozone absorbs light: as one filter for all light that passed the limb, or along the bent path of each ray.
enum class OzonePath { filter, bent };

/// Air over one part of the limb. Each constituent and effect can be switched off. The tables for a latitude and a
/// month (`seasonal_air` and others) are immutable and shared between columns.
struct Column {
  Density density = Density::yapo_cutler;
  bool refraction = true;  ///< if false, light goes straight through the air
  bool rayleigh = true;    ///< if false, molecules do not scatter
  double ozone_du = 0;     ///< vertical column of ozone [DU]; 0 means no ozone
  OzonePath ozone_path = OzonePath::filter;
  double dust_extinction_per_m = 0;  ///< grey extinction of the dust layer, 0 (no dust) to 0.01 m⁻¹
  double dust_bottom_m = 15e3, dust_top_m = 20e3;
  double tropospheric_optical_depth = 0;  ///< vertical, at 550 nm; 0 (no aerosol) to 10
  double tropospheric_scale_m = 2e3;      ///< scale height of tropospheric aerosol, 500 to 10 000 m
  StratosphericAerosol stratosphere = StratosphericAerosol::none;
  double stratospheric_factor =
      1;  ///< factor on the extinction of `stratosphere` or `stratospheric_layer`; 0 (off) to 100
  double cloud_top_m = 10e3;
  double cloud_cover = 0;  ///< share of the limb where cloud stops rays below cloud_top_m, 0 to 1

  double tropopause_m = 11e3;  ///< altitude, 5 to 20 km; the next three members depend on it
  double cloud_per_m = 0;      ///< probability of meeting cloud per metre of path, 0 to 0.01
  double cirrus = 0;           ///< multiplies cirrus_extinction_per_m; 0 (off) to 100
  /// Extinction by aerosol in the free troposphere, at an altitude of 7 km and at 550 nm [m⁻¹]; 0 (off) to 0.01.
  double free_troposphere_per_m = 0;
  bool oxygen_pairs = false, nitrogen_dioxide = false;  ///< whether oxygen pairs and NO₂ absorb
  bool oxygen_bands = false;                            ///< whether the bands of oxygen absorb
  double water_vapour = 0;  ///< amount relative to the US standard atmosphere, 0 (none) to 1000
  std::shared_ptr<const SeasonalAir> seasonal_air{};  ///< required if `density` is `seasonal`
  std::shared_ptr<const OzoneClimate>
      ozone_climate{};  ///< profile of ozone; nullptr means that of US 1976
  /// If not nullptr, this replaces `stratosphere`.
  std::shared_ptr<const StratosphericLayer> stratospheric_layer{};

  bool operator==(const Column&) const = default;
};

/// Altitude where a column's air ends [m]: 0, 42 000 or 86 000.
double top_m(const Column& column);

/// Air at a given angle from north along the limb, the same on the eastern and the western side.
struct Belt {
  double from_north_rad;  ///< angle along the limb, 0 to π
  Column column{};

  bool operator==(const Belt&) const = default;
};

/// Belts from north to south. Between two belts, the light is interpolated linearly in the position angle; north of the
/// first belt and south of the last, it is constant.
using Belts = std::vector<Belt>;

/// Part of the limb with its own air, from one position angle through east to another. Position angles are measured at
/// the Earth, about the shadow axis, from celestial north through east.
struct Region {
  algebra::Angle from, to;
  Column column{};
  Belts belts{};          ///< if not empty, these replace `column`
  bool mirrored = false;  ///< whether the region also covers the same angles with opposite sign

  bool operator==(const Region&) const = default;
};

/// Region between two latitudes, on the eastern and on the western limb; nullopt if no part of the limb lies between
/// these latitudes.
///
/// Given   sun_declination  angle by which the north pole is tipped towards the Sun
/// Throws  Error            when a latitude is outside ±90°, or `south` lies north of `north`
std::optional<Region> between_latitudes(algebra::Angle south, algebra::Angle north,
                                        algebra::Angle sun_declination, const Column& column);

enum class Dispersion { crc, ciddor_1996 };
enum class KingFactor { fixed, bates_1984 };  ///< `fixed` means F = 1.050

/// Models of refraction and scattering by the molecules of the air.
struct Molecules {
  Dispersion dispersion = Dispersion::crc;
  KingFactor king_factor = KingFactor::fixed;

  bool operator==(const Molecules&) const = default;
};

/// The Earth and its air. The first region that contains a position angle determines the air there; outside all
/// regions, `column` or `belts` do. The defaults are the sphere and air of Yapo & Cutler (2009), without ozone and
/// dust.
struct Atmosphere {
  Figure earth{};
  Molecules molecules{};
  Column column{};  ///< air outside all regions
  Belts belts{};    ///< air outside all regions; if not empty, these replace `column`
  std::vector<Region> regions{};

  bool operator==(const Atmosphere&) const = default;

  /// Weight of a column's light at a position angle.
  struct Share {
    std::size_t column;  ///< index into columns()
    double share;
  };

  /// Whether the air is the same along the whole limb.
  bool one_column() const { return regions.empty() && belts.empty(); }
  /// Whether, in some part of the limb, light is interpolated between belts of air.
  bool belted() const { return columns().size() > 1 + regions.size(); }
  /// Whether light does not depend on the position angle: a sphere with one column.
  bool symmetric() const { return one_column() && earth.sphere(); }
  /// Whether the air along the western half of the limb mirrors that along the eastern half.
  bool mirrored() const;
  /// Altitude up to which any column has air [m].
  double top_m() const;
  double top_radius_m() const { return earth.equatorial_radius_m + top_m(); }
  /// Columns of air outside all regions, then those of each region: one for each belt or, without belts, `column`.
  std::vector<const Column*> columns() const;
  /// Number of the region that contains a position angle, counted from 1; 0 outside all regions.
  std::size_t region_index(double position_angle_rad) const;
  /// Weights of the light from two columns at a position angle, which add up to 1. Without belts the second is 0.
  std::array<Share, 2> shares_at(double position_angle_rad) const;
  /// Position angles, increasing from 0 to 2π, between which the weights of all columns vary smoothly: the borders of
  /// regions and the middles of belts.
  std::vector<double> seams_rad() const;
  /// For each column, whether its weight is above 0 anywhere on the limb.
  std::vector<bool> columns_in_use() const;
};

/// Atmosphere with only every third belt, and with the first and the last, for a fast but coarse result.
Atmosphere with_fewer_belts(Atmosphere atmosphere);

/// Combines several atmospheres. Each column of the result has the largest amounts of dust, ozone, cloud and
/// stratospheric aerosol that the corresponding column has in any of them.
///
/// Given   airs   one or more atmospheres that differ only in these amounts and share tables such as SeasonalAir
/// Throws  Error  when there is no atmosphere, or they differ in anything else
Atmosphere richest(std::span<const Atmosphere> airs);

/// Throws an Error when a quantity is outside its range. The message gives the quantity's name, unit and range.
void require_valid(const Atmosphere& atmosphere);

/// Optical properties of air at sea level, at one wavelength.
struct Optics {
  double refractivity;    ///< n₀ − 1 at sea level
  double rayleigh_per_m;  ///< Rayleigh scattering coefficient at sea level, β₀ = N₀ σ
  double wavelength_nm;
};

/// Throws an Error when the wavelength is outside 380 to 780 nm.
Optics sea_level_optics(algebra::Wavelength wavelength, const Molecules& molecules = {});

/// Constituents that remove light from a ray. Each has a profile over altitude and a spectrum. Extinction is the sum of
/// spectrum × profile over all absorbers, optical depth the sum of spectrum × ∫ profile ds. A table in atmosphere.cpp
/// has a row for each absorber.
enum Absorber : std::size_t {
  air,
  ozone,
  dust_layer,
  troposphere,
  stratosphere,
  cloud,
  cirrus,
  free_troposphere,
  oxygen_pairs,
  nitrogen_dioxide,
  oxygen_bands,
  water_vapour,
  absorbers  ///< number of absorbers
};
using Amounts = std::array<double, absorbers>;

/// Name of each absorber's group: "air", "ozone", "dust", "aerosol" (below the stratosphere), "stratosphere", "cloud"
/// or "gas". Absorbers in a group are always changed together.
std::array<std::string_view, absorbers> absorber_groups();

/// Multiplies a column's cloud (including its cloud cover) and its aerosol below the stratosphere by a factor.
void scale_cloud_and_aerosol(Column& column, double factor);

/// Whether a column contains an absorber.
bool has(const Column& column, Absorber absorber);

/// Profile of one absorber at an altitude; 0 if the column lacks the absorber.
double profile(const Column& column, Absorber absorber, double altitude_m);

/// Profiles of all absorbers at an altitude:
///
///     air                ρ/ρ₀
///     ozone              share of the vertical column per metre [m⁻¹]
///     dust_layer         1 within the layer
///     troposphere        share of the vertical optical depth per metre [m⁻¹]
///     stratosphere       extinction at 550 nm [m⁻¹]
///     cloud              cloud_profile
///     cirrus             extinction [m⁻¹]
///     free_troposphere   extinction at 550 nm [m⁻¹]
///     oxygen_pairs       (ρ/ρ₀)²
///     nitrogen_dioxide   molecules [m⁻³]
///     oxygen_bands       ρ/ρ₀
///     water_vapour       water_vapour_profile
Amounts profiles(const Column& column, double altitude_m);

/// Spectra of all absorbers: the factors that turn profiles into extinction [m⁻¹], and profiles integrated along a
/// path into optical depth. For ozone as a filter (OzonePath::filter) the factor is 0.
Amounts spectra(const Column& column, const Optics& optics);

/// Phase function times albedo: the ratio of the light that each absorber scatters per steradian to its extinction.
///
///     ω P(χ) / (4π)        P = 3/4 (1 + cos² χ) for air, (1 − g²) / (1 + g² − 2 g cos χ)^3/2 for aerosol
///
/// (ω, g) = (1, 0.685) for background sulphuric acid, (0.947, 0.698) for aged volcanic aerosol and dust, (0.855,
/// 0.747) for fresh volcanic aerosol, (0.963, 0.651) for tropospheric aerosol.
///
/// Given     cosine  cos χ, where χ is the scattering angle
/// Returned  [1/sr]  0 for gases that only absorb, and for cloud, whose scattered light is neglected
/// Source    Henyey & Greenstein (1941), ApJ 93, 70; ω and g at 550 nm from LOWTRAN 7: Kneizys et al.
///           (1988), AFGL-TR-88-0177
Amounts scattering(const Column& column, double cosine);

double product(const Amounts& a, const Amounts& b);

/// Altitudes where the slope of a column's profiles jumps [m], lowest first; the last is the top of the air.
std::vector<double> breaks_m(const Column& column);

/// Density ratio ρ/ρ₀ and its slope.
ValueAndSlope density_ratio(const Column& column, double altitude_m);

/// Refractivity n(h, λ) − 1: the value at sea level times the density ratio (Gladstone–Dale).
double refractivity(const Column& column, const Optics& optics, double altitude_m);

/// Smallest refractivity n₀ − 1 at sea level at which air traps light: n r, the refractive index times the distance
/// from the Earth's centre, then falls with altitude at the ground. A ray can leave the air only if n r rises.
///
///     n₀ − 1 = −1 / (ρ/ρ₀ + R d(ρ/ρ₀)/dh)     at the ground, where density falls fastest
///
/// Given     earth_radius_m  R, radius of curvature of the ground along the path
/// Returned  1.636e-3 with R = 6378 km, six times the refractivity of air; infinite if refraction is off
double critical_refractivity(const Column& column, double earth_radius_m);

/// Throws an Error when the air traps light. The message gives the air's refractivity and the largest one allowed.
void require_no_trap(const Column& column, double earth_radius_m, double refractivity);

/// Extinction [m⁻¹] at an altitude.
double extinction_per_m(const Column& column, const Optics& optics, double altitude_m);

/// Transmittance, 0 to 1, of cloud cover and of ozone as a filter (OzonePath::filter), for a ray that passes the limb.
///
/// Given  tangent_height_m  the ray's lowest altitude
double limb_filter(const Column& column, const Optics& optics, double tangent_height_m);

/// Vertical Rayleigh optical depth of the air above sea level.
double vertical_rayleigh_optical_depth(const Optics& optics);

}  // namespace coppermoon::atmosphere
