// SPDX-License-Identifier: MIT
#include "plan/laws.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plan/plan.h"

namespace coppermoon::plan {
namespace {

/// Time [s] of each step of the computation, measured on one core of a machine with AVX-512 at 3 GHz, under load.
struct Costs {
  double ray_followed = 8e-6;  ///< time to trace a ray; each part of the limb needs 250 or more
  double fan_ray = 58e-9;      ///< time per interpolated ray and wavelength
  double landed_ray = 160e-9;  ///< time to add up a ray's light, per wavelength and shadow plane
  double place = 33e-6;        ///< time to divide the Sun's disc into parts, per point in shadow
  double place_term = 6e-6;    ///< time of a disc integral, per point, harmonic and darkening term
  /// time to add one harmonic and darkening term of the light of one part of the limb, at one point and wavelength
  double place_wavelength = 74e-9;
  /// time to evaluate a harmonic at a position angle for one part of the limb, per point and limb-darkening term
  double angle_harmonic = 30e-9;
  /// time to add up light from one part of the limb at a position angle, per point, limb-darkening term and wavelength
  double angle_wavelength = 30e-9;
  double lookup = 6e-3;
  double trial = 45e-3;  ///< time to find how much refraction, flattening, scattering etc. matter
  double twilight = 40e-3, twilight_wavelength = 1e-3;
  double photon_wavelength = 2.2e-9;  ///< time per photon, wavelength and plane, in symmetric light
  double sectors_dearer = 8;          ///< slowdown of photons if light is not symmetric
  double photon_literal = 163e-6;
  double together = 1.75;  ///< measured time for the light / sum of the estimates above
  double start = 0.22;     ///< time to start the program and load image libraries
  double texel = 48e-9;    ///< time per texel to light it and to write it
  double map_file = 0.2;
};

/// Relative error of scattered light, which arises because it is computed at only a few places and wavelengths.
constexpr double scattered_error = 3e-3;

/// Relative error of luminance if only one photon were traced: two standard errors in the noisiest ring of 50 km width.
/// For N photons, the error is smaller by a factor of √N.
double noise(Solver solver) { return solver == Solver::literal ? 250 : 35; }

/// Number of sectors in which photons are gathered; 1 if light is symmetric about the shadow axis.
double sectors(const Work& work, const Scene& scene) {
  const bool alike = !(work.ellipsoid && scene.ellipsoid) && !(work.regions && scene.columns > 1);
  return alike ? 1 : 24;
}

/// Number of axis distances at which light is computed: one every 100 km, and those inserted to reach the tolerance.
double distances(const Work& work, const Scene& scene) {
  const double across_m = scene.farthest_m - scene.nearest_m;
  const double share = std::min(1., scene.without_refracted);
  return across_m / 100e3 + 2 + 26 * share * std::max(0., std::log10(0.1 / work.place_error));
}

/// Time on one core [s] to compute light at a number of places, once the light of all rays is added up where they land.
double seconds_of_places(const Work& work, const Scene& scene, double places) {
  const Costs cost;
  const bool regions = work.regions && scene.columns > 1;
  const double waves = 8 * std::ceil(work.bands / 8.);
  const double terms = scene.limb_darkening ? work.sun_terms : 1;
  const bool ellipsoid = work.ellipsoid && scene.ellipsoid;
  const double fewer = scene.borders && !ellipsoid ? 0.5 : 1;  // a sphere has half as many parts
  const double parts = regions ? fewer * static_cast<double>(scene.parts) : ellipsoid ? 2 : 1;
  // Regions need 50 harmonics on average. As all read the same sums of light, they cost as much as 25 computed singly.
  const double harmonics = regions ? (scene.borders ? 25 : 11) : ellipsoid ? 2 : 1;
  const double series =
      cost.place + terms * harmonics * (cost.place_term + cost.place_wavelength * parts * waves);
  if (!regions || !scene.borders) return places * series;
  const double centre_m = (scene.nearest_m + scene.farthest_m) / 2,
               half_m = (scene.farthest_m - scene.nearest_m) / 2;
  const auto half_arc = [&](double radius_m) {
    return centre_m > radius_m ? std::asin(radius_m / centre_m) / std::numbers::pi : 1;
  };
  constexpr double angles_around = 96, sun_m = 1.78e6, off_axis = 90, at_once = 8;
  const double angles = std::min(angles_around, angles_around * half_arc(half_m) + at_once),
               covered = parts * std::min(1., half_arc(sun_m) + 1. / 12);
  const double by_angle =
      cost.place + terms * harmonics * cost.place_term +
      angles * terms * covered * (cost.angle_harmonic * off_axis + cost.angle_wavelength * waves);
  return places * std::min(series, by_angle);
}

/// Time on one core [s] to compute light by quadrature.
double seconds_of_quadrature(const Work& work, const Scene& scene, double distances) {
  const Costs cost;
  const bool ellipsoid = work.ellipsoid && scene.ellipsoid;
  const bool regions = work.regions && scene.columns > 1;
  const double fewer = scene.borders && !ellipsoid ? 0.5 : 1;  // a sphere has half as many parts
  const double parts = regions ? fewer * static_cast<double>(scene.parts) : ellipsoid ? 2 : 1;
  const double rays = work.rays;
  // More rays need more divisions of the Sun's disc and, if the air has sharp borders, more harmonics too.
  const double cuts =
      regions && scene.borders && rays > 300 ? 1.3 * std::pow(rays / 300, 1.2) : 1 + rays / 1000;
  const double places = distances * work.planes * cuts;
  return cost.ray_followed * parts * (250 + 0.45 * rays) +
         parts * work.bands * rays * (cost.fan_ray + cost.landed_ray * work.planes) +
         seconds_of_places(work, scene, places);
}

/// Time on one core [s] to check the error of light at thirty places.
double seconds_of_check(const Work& work, const Scene& scene) {
  return seconds_of_quadrature(finer(work), scene, 8);
}

/// Factor by which a machine's cores speed up parallel work.
double cores(const Machine& machine) { return 1 + 0.85 * (machine.cores - 1); }

}  // namespace

double law(std::span<const LawPoint> points, double setting) {
  const auto above =
      std::ranges::find_if(points.subspan(1, points.size() - 2),
                           [&](const LawPoint& point) { return point.setting >= setting; });
  const auto i = static_cast<std::size_t>(above - points.begin());
  const auto &low = points[i - 1], &high = points[i];
  const double part = std::log(setting / low.setting) / std::log(high.setting / low.setting);
  // FAULT laws straight in errors, not in their logarithms: std::pow(high => std::lerp(1, high
  return low.error * std::pow(high.error / low.error, part);
}

double predicted_error(const Work& work, const Scene& scene) {
  const double share = std::min(1., scene.without_refracted);
  double error = 0;
  error += std::min(1., scene.without_scattered) * (work.scattered_light ? scattered_error : 1);
  if (!work.ellipsoid && scene.ellipsoid) error += scene.without_ellipsoid;
  if (!work.regions && scene.columns > 1) error += scene.without_regions;
  if (!work.refracted) return error + scene.without_refracted;
  const double everywhere = law(law_of_bands, work.bands) + law(law_of_planes, work.planes);
  if (traces_photons(work.solver))
    return error + share * (everywhere +
                            noise(work.solver) * std::sqrt(sectors(work, scene) / work.photons));
  const double knobs = everywhere + law(law_of_rays, work.rays) +
                       (scene.limb_darkening ? law(law_of_sun_terms, work.sun_terms) : 0) +
                       law(law_of_place_error, work.place_error);
  return error + share * knobs;
}

double predicted_seconds(const Work& work, const Scene& scene, const Machine& machine) {
  const Costs cost;
  double light = cost.trial + cost.lookup;
  if (work.scattered_light)
    light += cost.twilight + cost.twilight_wavelength * std::min(work.bands, 80);
  light += seconds_of_check(work, scene);
  if (work.refracted && work.solver == Solver::quadrature) {
    light += seconds_of_quadrature(work, scene, distances(work, scene));
  } else if (work.refracted) {
    const double dearer = sectors(work, scene) > 1 ? cost.sectors_dearer : 1;
    const double a_photon = work.solver == Solver::literal
                                ? cost.photon_literal
                                : dearer * cost.photon_wavelength * work.bands * work.planes;
    light += 0.05 + work.photons * a_photon;
  }
  const double map = scene.map_file ? cost.map_file : 0;  // only one core reads the albedo map
  const double start = scene.texels > 0 ? cost.start : 0;
  const double all = start + cost.together * light + cost.texel * scene.texels + map;
  return std::max(map, all / cores(machine)) / machine.speed;
}

}  // namespace coppermoon::plan
