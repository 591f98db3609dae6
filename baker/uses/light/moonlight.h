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
  std::optional<Shard> shard{};              ///< without: all photons
  std::filesystem::path keep{};              ///< file that the sums are written to; empty: none
  std::vector<std::filesystem::path> add{};  ///< files of sums whose photons are added
  std::string key{};  ///< recipe that the photons depend on; sums of another are refused

  /// Whether any of these is asked for; other solvers refuse them.
  bool asked_for() const { return shard || !keep.empty() || !add.empty(); }
};

using plan::Solver;

/// Sunlight that the air scatters into the shadow: computed or not; automatic: where it counts.
enum class ScatteredLight { automatic, on, off };

/// Request for light: Sun, Earth and air, and the solver.
struct LightRequest {
  Air air{};
  std::optional<bool> limb_darkening{};  ///< without: on, but for the atmosphere "paper"
  ScatteredLight scattered_light = ScatteredLight::automatic;
  bool starlight = false;
  /// automatic: the quickest, or photons by the table where `photons` is given
  Solver solver = Solver::automatic;
  plan::Wish wish{.tolerance = 0.01};
  plan::ByHand by_hand{};  ///< settings in place of planned ones, but for solver and photons
  std::optional<double> photons{};  ///< 1 to 1e12; without: as many as the tolerance asks for
  double step_km = 1;               ///< length of a step of a photon's path
  double ring_km = 50;              ///< width of the rings that gather photons
  double smoothing_km = 0;  ///< standard deviation of the Gaussian that smooths them, 0 to 2000
  std::uint64_t seed = 1;   ///< of the photons
  PhotonFiles photon_files{};
};

/// Scattered light of a request. With air of Danjon's scale `automatic` is off, as the scale was fitted to observed
/// eclipses, scattered light included.
ScatteredLight scattered_light_of(const LightRequest& request);

/// Sun's disc, limb-darkened or uniform, and the planes behind the Earth.
shadow::Arrangement arrangement_of(const LightRequest& request, double sun_distance_m,
                                   std::vector<double> depths_m);

/// Moon of one moment in the shadow of the request's Earth and air.
ShadowedMoon shadowed_moon(const LightRequest& request, const almanac::SkyState& sky);

/// Places where light is computed on each plane.
struct LightGrid {
  std::span<const double> wavelengths_nm;
  std::span<const double> axis_distances_m{};   ///< photons gather in rings of their own
  std::size_t around = shadow::sectors_around;  ///< sectors, where light differs around the axis
};

/// Refracted light by the solver asked for, with scattered light unless it is off or left out (`automatic` includes
/// it), and with starlight where it is on. Rays and terms of the Sun are chosen for a tolerance of 0.1 %, or the
/// request's where it is finer.
///
/// Throws  Error  when photons are asked for without their number
shadow::RefractedLight refracted_light(const LightRequest& request,
                                       const atmosphere::Atmosphere& air,
                                       const shadow::Arrangement& arrangement,
                                       const LightGrid& grid,
                                       const algebra::Progress& progress = {});

/// Light that falls on the Moon's sphere; without `refracted` unshadowed sunlight.
struct Moonlight {
  std::optional<shadow::RefractedLight> refracted;
  std::optional<shadow::DirectLight> direct;
  shadow::LookupRange range;
  plan::Plan plan;
  /// largest relative error of luminance on the disc, from that at some places, to which a fifth is added; 0: not told
  double error_found = 0;

  /// Given  weights  (channel, band)
  shadow::Lookup in_channels(const shadow::ChannelWeights& weights) const;

  /// Given  weights  (channel, wavelength), of the plan's `wavelengths_nm`
  shadow::Lookup in_sums(const shadow::ChannelWeights& weights, const shadow::LookupRange& within,
                         shadow::LightPart part = shadow::LightPart::all) const;
};

/// Refuses a moment without an eclipse.
///
/// Throws  Error  names the nearest eclipse, and then a way out of it
void require_eclipse(const almanac::Instant& when, const std::string& way_out = {},
                     almanac::Calendar calendar = almanac::Calendar::gregorian);

/// Light on the Moon of one moment, planned and computed.
///
/// Throws  Error  when the Moon is not in the Earth's shadow at that moment: names the nearest eclipse;
///                when the request is not sound
Moonlight light_on_the_moon(const LightRequest& request, const almanac::SkyState& sky,
                            const Purpose& purpose = {}, const algebra::Progress& progress = {});

/// Light as if the Earth were away.
///
/// Throws  Error  when the request is not sound
Moonlight unshadowed_light(const LightRequest& request, const almanac::SkyState& sky);

/// Plan of light_on_the_moon, without its work.
///
/// Throws  Error  as light_on_the_moon
plan::Plan planned_light(const LightRequest& request, const almanac::SkyState& sky,
                         const Purpose& purpose = {});

/// Whether photons make the light: they are the solver, or their number is given.
bool wants_photons(const LightRequest& request);

/// Skies along the Moon's path, at most three minutes apart: the path leaves a chord by 0.1 km.
std::vector<almanac::SkyState> skies_between(const almanac::Instant& from,
                                             const almanac::Instant& to);

/// Moon on its path through the shadow.
///
/// Given   skies  in order of time, at most a few minutes apart
/// Throws  Error  when no eclipse is under way at any of them: names the nearest there is
ShadowedMoon moon_on_its_way(const LightRequest& request, std::span<const almanac::SkyState> skies);

/// Light on a Moon's whole path, from one simulation.
Moonlight light_on_the_way(const LightRequest& request, const ShadowedMoon& moon,
                           const Purpose& purpose = {}, const algebra::Progress& progress = {});

/// Adds direct light to light that was read from a file.
///
/// Returned  whether the light belongs to that path
bool complete(const LightRequest& request, const ShadowedMoon& moon, Moonlight& light);

/// Range of the light on a Moon's path that its disc takes in at one moment; nothing where all is sunlight.
std::optional<shadow::LookupRange> range_at(const Moonlight& light, const almanac::SkyState& sky);

}  // namespace coppermoon::uses
