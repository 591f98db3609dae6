// SPDX-License-Identifier: MIT
#include "uses/light/shadow_profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "algebra/error.h"
#include "algebra/interpolation.h"
#include "eclipse/shadow_axis.h"
#include "shadow/lookup.h"

namespace coppermoon::uses {
namespace {

std::vector<double> distances_of(const ProfilePlaces& places, const ShadowCut& cut) {
  std::vector<double> distances;
  for (const double m : places.axis_distances_m) {
    algebra::require_within("axis distance [km]", m / 1e3, 0, 1e5);
    if (!distances.empty() && m <= distances.back())
      throw algebra::Error(
          fmt::format("axis distance [km] = {:g}, allowed above {:g}, the one before", m / 1e3,
                      distances.back() / 1e3));
    distances.push_back(m);
  }
  if (!distances.empty()) return distances;
  constexpr double spacing_m = 100e3;
  const double reach =
      shadow::refracted_reach_m(cut.arrangement, cut.air, cut.arrangement.depths_m[0]);
  for (double d = 0; d < reach + spacing_m; d += spacing_m) distances.push_back(d);
  return distances;
}

/// Standard errors, interpolated to the given axis distances; 0 beyond the last known distance.
algebra::Grid<double> errors_at(const shadow::RefractedLight& light, std::size_t sector,
                                const std::vector<double>& distances_m) {
  algebra::Grid<double> there(distances_m.size(), light.wavelengths_nm.size());
  if (light.standard_error.empty()) return there;
  const auto& values = light.standard_error[sector];
  std::vector<double> column(values.rows());
  for (std::size_t w = 0; w < values.columns(); ++w) {
    for (std::size_t d = 0; d < values.rows(); ++d) column[d] = values(d, w);
    for (std::size_t d = 0; d < distances_m.size(); ++d)
      if (distances_m[d] <= light.axis_distances_m.back())
        there(d, w) = algebra::interpolated(light.axis_distances_m, column, distances_m[d]);
  }
  return there;
}

/// Weight of each sector for cubic interpolation at a position angle. If no angle is given, all weights are equal.
std::vector<double> sector_shares(std::size_t sectors, std::optional<double> position_angle_deg) {
  if (!position_angle_deg) return std::vector<double>(sectors, 1 / static_cast<double>(sectors));
  std::vector<double> shares(sectors);
  const auto some =
      algebra::on_circle(sectors, *position_angle_deg / 360 * static_cast<double>(sectors));
  for (std::size_t i = 0; i < some.at.size(); ++i) shares[some.at[i]] += some.share[i];
  return shares;
}

}  // namespace

ShadowCut shadow_at_the_moon(const LightRequest& request, const almanac::SkyState& sky) {
  const auto moon = shadowed_moon(request, sky);
  return {request.by_hand.terms ? air_for(*request.by_hand.terms, moon) : moon.air,
          arrangement_of(moon, {algebra::in_metres(moon.centre.depth)})};
}

ShadowProfile shadow_profile(const LightRequest& request, const ShadowCut& cut,
                             const ProfilePlaces& places, const algebra::Progress& progress) {
  if (places.wavelengths_nm.empty())
    throw algebra::Error("wavelengths [nm] = none, allowed one or more");
  ShadowProfile profile{places.wavelengths_nm, distances_of(places, cut), {}, {}};
  const auto& distances = profile.axis_distances_m;
  const auto light = refracted_light(request, cut.air, cut.arrangement,
                                     {profile.wavelengths_nm, distances}, progress);
  const shadow::DirectLight direct(cut.air, cut.arrangement, profile.wavelengths_nm);
  profile.ratio = algebra::Grid<double>(distances.size(), profile.wavelengths_nm.size());
  profile.standard_error = profile.ratio;
  const auto shares = sector_shares(light.sectors, places.position_angle_deg);
  const shadow::BetweenPlaces between(light);
  std::vector<double> clear(profile.wavelengths_nm.size()), refracted(clear);
  for (std::size_t s = 0; s < shares.size(); ++s) {
    if (shares[s] == 0) continue;
    const double angle = shadow::Sectors{shares.size()}.angle_rad(s);
    const auto error = errors_at(light, s, distances);
    for (std::size_t d = 0; d < distances.size(); ++d) {
      direct.ratios(distances[d], angle, cut.arrangement.depths_m[0], clear);
      between.read(0, s, distances[d], refracted);
      for (std::size_t w = 0; w < clear.size(); ++w) {
        profile.ratio(d, w) += shares[s] * (refracted[w] + clear[w]);
        profile.standard_error(d, w) =
            std::hypot(profile.standard_error(d, w), shares[s] * error(d, w));
      }
    }
  }
  for (double& value : profile.ratio.values()) value = std::max(value, 0.);  // cuts noise below 0
  return profile;
}

}  // namespace coppermoon::uses
