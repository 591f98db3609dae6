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

/// How the photons are divided among several runs: the shard that this run traces, and files with sums of photons.
struct PhotonFiles {
  std::optional<Shard> shard{};              ///< if absent, all photons
  std::filesystem::path keep{};              ///< file to write the sums to; not written if empty
  std::vector<std::filesystem::path> add{};  ///< files with sums to add
  std::string key{};  ///< recipe of the photons; sums with a different recipe are refused

  /// Whether a shard or any file is requested. Only the photon solvers accept such a request.
  bool asked_for() const { return shard || !keep.empty() || !add.empty(); }
};

using plan::Solver;

/// Whether to compute sunlight that the air scatters into the shadow. `automatic` computes it if it matters.
enum class ScatteredLight { automatic, on, off };

/// Request for light: the Sun, the Earth and its air, and how the light is computed.
struct LightRequest {
  Air air{};
  std::optional<bool> limb_darkening{};  ///< if absent, on unless the atmosphere is "paper"
  ScatteredLight scattered_light = ScatteredLight::automatic;
  bool starlight = false;
  /// `automatic` means the quickest solver, or the photon solver `table` if `photons` is given.
  Solver solver = Solver::automatic;
  plan::Wish wish{.tolerance = 0.01};
  plan::ByHand by_hand{};           ///< the user's settings, except for solver and photons
  std::optional<double> photons{};  ///< number, 1 to 1e12; if absent, enough for the tolerance
  double step_km = 1;               ///< step along a photon's path in the solver `literal`
  double ring_km = 50;              ///< width of the rings that gather photons
  double smoothing_km = 0;  ///< standard deviation of the Gaussian that smooths photons, 0 to 2000
  std::size_t seed = 1;     ///< seed of the random numbers for photons
  PhotonFiles photon_files{};
};

/// Whether a request asks for scattered light. For air on Danjon's scale, `automatic` means off, because the scale was
/// fitted to observed eclipses, whose light already includes scattered light.
ScatteredLight scattered_light_of(const LightRequest& request);

/// Whether the Sun is limb-darkened, which is the default except with the atmosphere "paper".
bool limb_darkening_of(const LightRequest& request);

/// The Moon at one moment, in the shadow of the requested Earth and air.
ShadowedMoon shadowed_moon(const LightRequest& request, const almanac::SkyState& sky);

/// Wavelengths and places at which light is computed on each plane across the shadow.
struct LightGrid {
  std::span<const double> wavelengths_nm;
  std::span<const double> axis_distances_m{};   ///< unused by photons, which are gathered in rings
  std::size_t around = shadow::sectors_around;  ///< number of sectors, unless light is symmetric
};

/// Refracted light, computed by the requested solver. Scattered light is included unless scattered_light_of returns
/// `off` or `by_hand.terms` omits it. Starlight is included if requested. The numbers of rays and of terms for limb
/// darkening are chosen for a tolerance of 0.1 %, or for the requested tolerance if that is finer.
///
/// Throws  Error  when photons are requested without their number
shadow::RefractedLight refracted_light(const LightRequest& request,
                                       const atmosphere::Atmosphere& air,
                                       const shadow::Arrangement& arrangement,
                                       const LightGrid& grid,
                                       const algebra::Progress& progress = {});

/// Light that falls on the Moon. If `refracted` is absent, the light is unshadowed sunlight.
struct Moonlight {
  std::optional<shadow::RefractedLight> refracted;
  std::optional<shadow::DirectLight> direct;
  shadow::LookupRange range;
  plan::Plan plan;
  /// Largest relative error of luminance on the disc: 1.2 times the largest at sample places, or 0 if not determined.
  double error_found = 0;

  /// Look-up table of the light in channels, with weights (channel, band) for the bands of band_edges_nm.
  shadow::Lookup in_channels(const shadow::ChannelWeights& weights) const;

  /// Look-up table of the light in channels, with weights (channel, wavelength) for the plan's wavelengths.
  shadow::Lookup in_sums(const shadow::ChannelWeights& weights, const shadow::LookupRange& within,
                         shadow::LightPart part = shadow::LightPart::all) const;
};

/// Refuses a moment without an eclipse.
///
/// Throws  Error  if there is none; the message names the nearest eclipse and ends with `way_out`
void require_eclipse(const almanac::Instant& when, const std::string& way_out = {},
                     almanac::Calendar calendar = almanac::Calendar::gregorian);

/// Plans and computes the light on the Moon at one moment.
///
/// Throws  Error  when the request is invalid, or there is no eclipse at that moment; the message names the nearest one
Moonlight light_on_the_moon(const LightRequest& request, const almanac::SkyState& sky,
                            const Purpose& purpose = {}, const algebra::Progress& progress = {});

/// Light on the Moon as if the Earth were not there.
///
/// Throws  Error  when the request is invalid
Moonlight unshadowed_light(const LightRequest& request, const almanac::SkyState& sky);

/// The plan that light_on_the_moon would follow, without computing any light.
///
/// Throws  Error  when light_on_the_moon would
plan::Plan planned_light(const LightRequest& request, const almanac::SkyState& sky,
                         const Purpose& purpose = {});

/// Whether the request asks for photons, either through its solver or by giving their number.
bool wants_photons(const LightRequest& request);

/// Skies along the Moon's path, at most three minutes apart. Between two of them, the path is straight within 0.1 km.
std::vector<almanac::SkyState> skies_between(const almanac::Instant& from,
                                             const almanac::Instant& to);

/// The Moon on its path through the shadow.
///
/// Given   skies  in order of time, at most a few minutes apart
/// Throws  Error  when none of the skies falls within an eclipse; the message names the nearest eclipse
ShadowedMoon moon_on_its_way(const LightRequest& request, std::span<const almanac::SkyState> skies);

/// Light along the Moon's whole path, computed in one simulation.
Moonlight light_on_the_way(const LightRequest& request, const ShadowedMoon& moon,
                           const Purpose& purpose = {}, const algebra::Progress& progress = {});

/// Adds direct light to light that was read from a file.
///
/// Returned  false if the light was computed for another path of the Moon; in that case nothing is added
bool complete(const ShadowedMoon& moon, Moonlight& light);

/// Part of the light along the Moon's path that the disc covers at one moment; nullopt if the whole disc is unshadowed.
std::optional<shadow::LookupRange> range_at(const Moonlight& light, const almanac::SkyState& sky);

}  // namespace coppermoon::uses
