// SPDX-License-Identifier: MIT
#include "plan/laws.h"

#include <algorithm>
#include <cmath>

#include "plan/plan.h"

namespace coppermoon::plan {
namespace {

/// Seconds on one core of the machine that the model was measured on: AVX-512 at 3 GHz.
struct Costs {
  double start = 1.5e-3;           ///< of any light
  double ray_followed = 20e-6;     ///< through the air, by limb_path
  double fan_ray = 35e-9;          ///< of one wavelength
  double landed_ray = 120e-9;      ///< of one wavelength on one plane
  double place = 14e-6;            ///< and disc's term: the arcs the disc takes in
  double place_wavelength = 9e-9;  ///< and disc's term, of one part of the limb
  double lookup_node = 2e-6;
  double twilight = 40e-3, twilight_wavelength = 1e-3;
  double photon_wavelength = 2.2e-9;  ///< by the table, on one plane
  double photon_marched = 14e-6, photon_literal = 163e-6;
  double texel = 12e-9;
  double map_file = 0.2;
  double texel_resized = 6e-9;
};

/// Two standard errors of luminance in the worst ring of 50 km of one photon; they fall as the root
/// of the number.
double noise(Method method) { return method == Method::literal ? 200 : 25; }

/// Axis distances that light is computed at: every 200 km, and more where it is not smooth.
double distances(const Work& work, const Scene& scene) {
  const double across_km = (scene.farthest_m - scene.nearest_m) / 1e3;
  const double share = std::min(1., scene.without_refracted);
  return across_km / 200 * 2 + 3 +
         12 * share * std::max(0., std::log10(0.3 / work.place_error)) *
             std::pow(0.1 / work.place_error, 0.2);
}

/// How much of a scene's parallel work one more core takes off.
double cores(const Machine& machine) { return 1 + 0.85 * (machine.cores - 1); }

}  // namespace

double law(std::span<const LawPoint> points, double setting) {
  const auto above =
      std::ranges::find_if(points.subspan(1, points.size() - 2),
                           [&](const LawPoint& point) { return point.setting >= setting; });
  const auto i = static_cast<std::size_t>(above - points.begin());
  const auto &low = points[i - 1], &high = points[i];
  const double part = std::log(setting / low.setting) / std::log(high.setting / low.setting);
  return low.error * std::pow(high.error / low.error, part);
}

double predicted_error(const Work& work, const Scene& scene) {
  const double share = std::min(1., scene.without_refracted);
  double error = 0;
  if (!work.scattered_light) error += scene.without_scattered;
  if (!work.refracted) return error + scene.without_refracted;
  if (!work.ellipsoid && scene.ellipsoid) error += scene.without_ellipsoid;
  if (!work.regions && scene.columns > 1) error += scene.without_regions;
  const double everywhere = law(law_of_bands, work.bands) + law(law_of_planes, work.planes);
  if (work.method != Method::quadrature)
    return error + share * (everywhere + noise(work.method) / std::sqrt(work.photons));
  const double knobs = everywhere + law(law_of_rays, work.rays) +
                       (scene.limb_darkening ? law(law_of_sun_terms, work.sun_terms) : 0) +
                       law(law_of_planes, work.planes) + law(law_of_place_error, work.place_error);
  return error + share * knobs;
}

double predicted_seconds(const Work& work, const Scene& scene, const Machine& machine) {
  const Costs cost;
  double seconds = cost.start + cost.texel * scene.texels;
  if (scene.map_file) seconds += cost.map_file + cost.texel_resized * scene.texels;
  if (work.scattered_light)
    seconds += cost.twilight + cost.twilight_wavelength * std::min(work.bands, 80);
  if (work.refracted && work.method != Method::quadrature) {
    const double a_photon = work.method == Method::literal
                                ? cost.photon_literal
                                : cost.photon_wavelength * work.bands * work.planes +
                                      (work.method == Method::marched ? cost.photon_marched : 0);
    seconds += 0.05 + work.photons * a_photon;
  } else if (work.refracted) {
    const double columns = work.regions ? static_cast<double>(scene.columns) : 1;
    const bool ellipsoid = work.ellipsoid && scene.ellipsoid;
    const double parts = columns * (ellipsoid ? 2 : 1);
    const double angles = columns > 1 ? static_cast<double>(scene.sectors) : ellipsoid ? 3 : 1;
    const double waves = 8 * std::ceil(work.bands / 8.), rays = work.rays;
    const double terms = scene.limb_darkening ? work.sun_terms : 1;
    const double places = distances(work, scene) * angles * work.planes;
    seconds += cost.ray_followed * parts * (150 + 0.6 * rays) +
               parts * waves * rays * (cost.fan_ray + cost.landed_ray * work.planes) +
               places * terms * (cost.place + cost.place_wavelength * waves * parts);
  }
  return seconds / machine.speed / cores(machine) + scene.other_seconds;
}

}  // namespace coppermoon::plan
