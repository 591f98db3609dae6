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

/// How the density of the air varies with altitude: no air; US 1976 with the ramp of Yapo & Cutler (2009), which ends
/// at 42 km; US 1976 up to 86 km; by latitude and season (SeasonalAir), up to 86 km.
enum class Density { none, yapo_cutler, us_1976, seasonal };

/// How ozone absorbs: as one filter for all light that passed the limb, or along each ray's own path.
enum class OzonePath { filter, bent };

/// Air over one part of the limb. Each term can be switched off. The tables for a latitude and a
/// month (`seasonal_air` and others) are immutable and shared between columns.
struct Column {
  Density density = Density::yapo_cutler;
  bool refraction = true;  ///< off: light goes straight through the air
  bool rayleigh = true;    ///< off: molecules do not scatter
  double ozone_du = 0;     ///< vertical column [DU]; 0: off
  OzonePath ozone_path = OzonePath::filter;
  double dust_extinction_per_m = 0;  ///< grey extinction α of the dust layer, 0 to 0.01 m⁻¹; 0: off
  double dust_bottom_m = 15e3, dust_top_m = 20e3;
  double tropospheric_optical_depth = 0;  ///< vertical, due to aerosol, at 550 nm, 0 to 10; 0: off
  double tropospheric_scale_m = 2e3;      ///< scale height of that aerosol, 500 to 10 000 m
  StratosphericAerosol stratosphere = StratosphericAerosol::none;
  double stratospheric_factor =
      1;  ///< factor on `stratosphere` or `stratospheric_layer`, 0 to 100; 0: off
  double cloud_top_m = 10e3;
  double cloud_cover = 0;  ///< share of the limb where cloud stops all rays below its top; 0: off

  double tropopause_m = 11e3;  ///< 5 to 20 km; the next three terms depend on it
  double cloud_per_m = 0;      ///< probability per metre of meeting cloud, 0 to 0.01 m⁻¹; 0: off
  double cirrus = 0;           ///< factor on cirrus_extinction_per_m, 0 to 100; 0: off
  /// extinction by the free troposphere's aerosol at 7 km and 550 nm, 0 to 0.01; 0: off
  double free_troposphere_per_m = 0;
  bool oxygen_pairs = false, nitrogen_dioxide = false;  ///< whether oxygen pairs and NO₂ absorb
  bool oxygen_bands = false;                            ///< whether the bands of oxygen absorb
  double water_vapour = 0;  ///< relative to the US standard atmosphere, 0 to 1000; 0: off
  std::shared_ptr<const SeasonalAir> seasonal_air{};  ///< for Density::seasonal
  std::shared_ptr<const OzoneClimate>
      ozone_climate{};  ///< profile of ozone; if null, that of US 1976
  /// unless null, replaces `stratosphere`
  std::shared_ptr<const StratosphericLayer> stratospheric_layer{};

  bool operator==(const Column&) const = default;
};

/// Altitude where a column's air ends [m]: 0, 42 000 or 86 000.
double top_m(const Column& column);

/// Air at one angular distance from north along the limb, to the east and to the west alike.
struct Belt {
  double from_north_rad;  ///< 0 to π
  Column column{};

  bool operator==(const Belt&) const = default;
};

/// Belts from north to south. Between two belts, light is interpolated linearly in the position angle; north of
/// the first belt and south of the last, light is constant.
using Belts = std::vector<Belt>;

/// Part of the limb with its own air: from one position angle through east to the other.
/// Position angles are measured at the Earth, about the shadow axis, from celestial north through
/// east.
struct Region {
  algebra::Angle from, to;
  Column column{};
  Belts belts{};          ///< unless empty, replace the column
  bool mirrored = false;  ///< whether the region includes the negative position angles too

  bool operator==(const Region&) const = default;
};

/// Region between two latitudes, in the east and the west of the limb; nothing if no part of the limb lies between
/// these latitudes.
///
/// Given   sun_declination  angle by which the north pole is tipped towards the Sun
/// Throws  Error            when a latitude is outside ±90°, or south is north of north
std::optional<Region> between_latitudes(algebra::Angle south, algebra::Angle north,
                                        algebra::Angle sun_declination, const Column& column);

enum class Dispersion { crc, ciddor_1996 };
enum class KingFactor { fixed, bates_1984 };  ///< fixed: 1.050

/// Models of refraction and scattering by the molecules of the air.
struct Molecules {
  Dispersion dispersion = Dispersion::crc;
  KingFactor king_factor = KingFactor::fixed;

  bool operator==(const Molecules&) const = default;
};

/// Earth and its air. A position angle has the air of the first region that contains it; outside all regions,
/// `column` or `belts` hold. The defaults are the sphere and the air of Yapo & Cutler (2009), without ozone and
/// dust.
struct Atmosphere {
  Figure earth{};
  Molecules molecules{};
  Column column{};  ///< outside all regions
  Belts belts{};    ///< outside all regions; unless empty, replace the column
  std::vector<Region> regions{};

  bool operator==(const Atmosphere&) const = default;

  /// Weight of a column's light at a position angle.
  struct Share {
    std::size_t column;  ///< index in `columns`
    double share;
  };

  /// Whether the whole limb has one column.
  bool one_column() const { return regions.empty() && belts.empty(); }
  /// Whether some part of the limb lies between belts.
  bool belted() const { return columns().size() > 1 + regions.size(); }
  /// Whether light does not depend on the position angle: a sphere with one column.
  bool symmetric() const { return one_column() && earth.sphere(); }
  /// Whether the limb's western half has the air of its eastern half, mirrored.
  bool mirrored() const;
  /// Altitude where the air of the highest column ends [m].
  double top_m() const;
  double top_radius_m() const { return earth.equatorial_radius_m + top_m(); }
  /// All columns: first those outside all regions, then those of each region. Belts, if there are any, take the
  /// column's place.
  std::vector<const Column*> columns() const;
  /// Number of the region that contains a position angle, from 1; 0 outside all regions.
  std::size_t region_index(double position_angle_rad) const;
  /// Weights of the light from two columns at a position angle. They add up to 1; the second is 0 where there are
  /// no belts.
  std::array<Share, 2> shares_at(double position_angle_rad) const;
  /// Position angles, increasing from 0 to 2π, between which the weights of all columns are smooth: the borders of
  /// regions and the middles of belts.
  std::vector<double> seams_rad() const;
  /// For each column, whether it has a weight anywhere on the limb.
  std::vector<bool> columns_in_use() const;
};

/// Air with only every third of its belts, including the first and the last: cheap, for a coarse result.
Atmosphere with_fewer_belts(Atmosphere atmosphere);

/// Air that has, column by column, the largest amount of dust, of ozone, of cloud and of stratospheric aerosol among
/// several airs.
///
/// Given   airs   one or more, which differ only in these amounts and share their tables
/// Throws  Error  when there are no airs, or they differ in anything else
Atmosphere richest(std::span<const Atmosphere> airs);

/// Throws Error when a term is outside its range: names the term, its unit and its range.
void require_valid(const Atmosphere& atmosphere);

/// Optical properties of air at sea level, at one wavelength.
struct Optics {
  double refractivity;    ///< n₀ − 1
  double rayleigh_per_m;  ///< β₀ = N₀ σ
  double wavelength_nm;
};

/// Throws Error when the wavelength is outside 380 to 780 nm
Optics sea_level_optics(algebra::Wavelength wavelength, const Molecules& molecules = {});

/// Constituents that take light out of a ray, each with a profile over altitude and a spectrum. Extinction is
/// Σ spectrum × profile over absorbers; optical depth Σ spectrum × ∫ profile ds. A table in atmosphere.cpp has a
/// row for each absorber.
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
  absorbers  ///< their number
};
using Amounts = std::array<double, absorbers>;

/// Group of each absorber; a change of the air affects a whole group: "air", "ozone", "dust", "aerosol" below the
/// stratosphere, "stratosphere", "cloud", "gas".
std::array<std::string_view, absorbers> absorber_groups();

/// Multiplies a column's cloud (including a cloud deck) and its aerosol below the stratosphere by a factor.
void scale_cloud_and_aerosol(Column& column, double factor);

/// Whether a column has an absorber.
bool has(const Column& column, Absorber absorber);

/// Profile of one absorber at an altitude; 0 if the column lacks the absorber.
double profile(const Column& column, Absorber absorber, double altitude_m);

/// Profiles of all absorbers at an altitude:
///
///     air                ρ/ρ₀
///     ozone              share of the vertical column in a metre [m⁻¹]
///     dust_layer         1 within the layer
///     troposphere        share of the vertical optical depth in a metre [m⁻¹]
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

/// Phase functions times albedo: ratio of the light that each absorber scatters per steradian to its extinction.
///
///     ω P(χ) / (4π)        P = 3/4 (1 + cos² χ) for air, (1 − g²) / (1 + g² − 2 g cos χ)^3/2 for aerosol
///
/// (ω, g) = (1, 0.685) for background sulphuric acid, (0.947, 0.698) for aged volcanic aerosol and dust, (0.855,
/// 0.747) for fresh volcanic aerosol, (0.963, 0.651) for tropospheric aerosol.
///
/// Given     cosine  cos χ, χ the scattering angle
/// Returned  [1/sr]  0 for gases that only absorb, and for cloud, which the twilight leaves out
/// Source    Henyey & Greenstein (1941), ApJ 93, 70; ω and g at 550 nm of LOWTRAN 7: Kneizys et al.
///           (1988), AFGL-TR-88-0177
Amounts scattering(const Column& column, double cosine);

double product(const Amounts& a, const Amounts& b);

/// Altitudes where the slope of a column's profiles jumps [m], lowest first; the last is the top of its air.
std::vector<double> breaks_m(const Column& column);

/// Density ratio ρ/ρ₀ and its slope.
ValueAndSlope density_ratio(const Column& column, double altitude_m);

/// Refractivity n(h, λ) − 1: the value at sea level times the density ratio (Gladstone–Dale).
double refractivity(const Column& column, const Optics& optics, double altitude_m);

/// Least refractivity n₀ − 1 at sea level that traps light in the air: a ray can leave again only if n r rises
/// with altitude, and from this refractivity on n r falls at the ground.
///
///     n₀ − 1 = −1 / (ρ/ρ₀ + R d(ρ/ρ₀)/dh)     at the ground, where density falls fastest
///
/// Given     earth_radius_m  R, radius of curvature of the ground along the path
/// Returned  1.636e-3 with R = 6378 km, six times that of air; infinite if refraction is off
double critical_refractivity(const Column& column, double earth_radius_m);

/// Throws Error when the air traps light: names its refractivity and the largest one allowed.
void require_no_trap(const Column& column, double earth_radius_m, double refractivity);

/// Extinction [m⁻¹] at an altitude.
double extinction_per_m(const Column& column, const Optics& optics, double altitude_m);

/// Transmittance, 0 to 1, of cloud cover and of ozone as a filter (OzonePath::filter), for a ray past the limb.
///
/// Given  tangent_height_m  the ray's lowest altitude
double limb_filter(const Column& column, const Optics& optics, double tangent_height_m);

/// Vertical Rayleigh optical depth of the air above sea level.
double vertical_rayleigh_optical_depth(const Optics& optics);

}  // namespace coppermoon::atmosphere
