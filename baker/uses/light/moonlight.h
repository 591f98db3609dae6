// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "algebra/progress.h"
#include "almanac/sky.h"
#include "shadow/by_photons.h"
#include "shadow/irradiance.h"
#include "shadow/lookup.h"
#include "uses/light/air.h"
#include "uses/light/planning.h"
#include "uses/light/shard.h"

namespace coppermoon::uses {

/// Photons shared among runs: the shard of this run, and files of sums.
struct PhotonFiles {
  std::optional<Shard> shard{};              ///< if absent, all photons
  std::filesystem::path keep{};              ///< file to write the sums to, if not empty
  std::vector<std::filesystem::path> add{};  ///< files with sums to add
  std::string key{};  ///< recipe of these photons; sums with a different one are refused

  /// Whether any of these is requested; other solvers refuse such a request.
  bool asked_for() const { return shard || !keep.empty() || !add.empty(); }
};

using plan::Solver;

/// Whether to compute sunlight that the air scatters into the shadow; automatic: if it matters.
enum class ScatteredLight { automatic, on, off };

/// Request for light: Sun, Earth and air, and the solver.
struct LightRequest {
  Air air{};
  std::optional<bool> limb_darkening{};  ///< if absent, on except with the atmosphere "paper"
  ScatteredLight scattered_light = ScatteredLight::automatic;
  bool starlight = false;
  /// automatic: the quickest solver, or photons with tables if `photons` is given
  Solver solver = Solver::automatic;
  plan::Wish wish{.tolerance = 0.01};
  plan::ByHand by_hand{};           ///< replace planned settings, except solver and photons
  std::optional<double> photons{};  ///< 1 to 1e12; if absent, as many as the tolerance needs
  double step_km = 1;               ///< length of a step of a photon's path
  double ring_km = 50;              ///< width of the rings that gather photons
  double smoothing_km = 0;  ///< standard deviation of the Gaussian that smooths them, 0 to 2000
  std::uint64_t seed = 1;   ///< for the photons
  PhotonFiles photon_files{};
};

/// Scattered light that a request asks for. With air on Danjon's scale, `automatic` means off, since the scale was
/// fitted to observed eclipses, which include scattered light.
ScatteredLight scattered_light_of(const LightRequest& request);

/// Whether the Sun is limb-darkened: as requested, by default except with the atmosphere "paper".
bool limb_darkening_of(const LightRequest& request);

/// The Moon at one moment, in the shadow of the requested Earth and air.
ShadowedMoon shadowed_moon(const LightRequest& request, const almanac::SkyState& sky);

/// Wavelengths and places at which light is computed on each plane.
struct LightGrid {
  std::span<const double> wavelengths_nm;
  std::span<const double> axis_distances_m{};   ///< photons use rings instead
  std::size_t around = shadow::sectors_around;  ///< sectors, if light varies around the axis
};

/// Refracted light by the requested solver. Scattered light is included unless it is off or left out (`automatic`
/// includes it), and starlight if it is on. Rays and terms of the Sun are chosen for a tolerance of 0.1 %, or for the
/// request's if that is finer.
///
/// Throws  Error  when photons are requested without a number of them
shadow::RefractedLight refracted_light(const LightRequest& request,
                                       const atmosphere::Atmosphere& air,
                                       const shadow::Arrangement& arrangement,
                                       const LightGrid& grid,
                                       const algebra::Progress& progress = {});

/// Light that falls on the Moon's sphere. If `refracted` is absent, it is unshadowed sunlight.
struct Moonlight {
  std::optional<shadow::RefractedLight> refracted;
  std::optional<shadow::DirectLight> direct;
  shadow::LookupRange range;
  plan::Plan plan;
  /// largest relative error of luminance on the disc: the largest at sample places plus a fifth; 0: not determined
  double error_found = 0;

  /// Given  weights  (channel, band)
  shadow::Lookup in_channels(const shadow::ChannelWeights& weights) const;

  /// Given  weights  (channel, wavelength), for the plan's `wavelengths_nm`
  shadow::Lookup in_sums(const shadow::ChannelWeights& weights, const shadow::LookupRange& within,
                         shadow::LightPart part = shadow::LightPart::all) const;
};

/// Refuses a moment without an eclipse.
///
/// Throws  Error  which names the nearest eclipse, followed by `way_out`
void require_eclipse(const almanac::Instant& when, const std::string& way_out = {},
                     almanac::Calendar calendar = almanac::Calendar::gregorian);

/// Plans and computes the light on the Moon at one moment.
///
/// Throws  Error  when the Moon is not in the Earth's shadow at that moment (names the nearest eclipse), or the
///                request is invalid
Moonlight light_on_the_moon(const LightRequest& request, const almanac::SkyState& sky,
                            const Purpose& purpose = {}, const algebra::Progress& progress = {});

/// Light on the Moon as if the Earth were not there.
///
/// Throws  Error  when the request is invalid
Moonlight unshadowed_light(const LightRequest& request, const almanac::SkyState& sky);

/// The plan that light_on_the_moon would follow, without computing any light.
///
/// Throws  Error  as light_on_the_moon
plan::Plan planned_light(const LightRequest& request, const almanac::SkyState& sky,
                         const Purpose& purpose = {});

/// Whether the request asks for photons, as its solver or by giving their number.
bool wants_photons(const LightRequest& request);

/// Skies along the Moon's path, at most three minutes apart. Between them the path strays 0.1 km from a straight line.
std::vector<almanac::SkyState> skies_between(const almanac::Instant& from,
                                             const almanac::Instant& to);

/// The Moon on its path through the shadow.
///
/// Given   skies  in order of time, at most a few minutes apart
/// Throws  Error  when no eclipse is under way at any of them (names the nearest eclipse)
ShadowedMoon moon_on_its_way(const LightRequest& request, std::span<const almanac::SkyState> skies);

/// Light on a Moon's whole path, from one simulation.
Moonlight light_on_the_way(const LightRequest& request, const ShadowedMoon& moon,
                           const Purpose& purpose = {}, const algebra::Progress& progress = {});

/// Adds direct light to light that was read from a file.
///
/// Returned  whether the light belongs to the Moon's path
bool complete(const ShadowedMoon& moon, Moonlight& light);

/// Range of the light on the Moon's path that its disc covers at one moment; nothing for unshadowed sunlight.
std::optional<shadow::LookupRange> range_at(const Moonlight& light, const almanac::SkyState& sky);

}  // namespace coppermoon::uses
