// SPDX-License-Identifier: MIT
#include "almanac/ephemeris.h"

#include <erfa.h>
#include <erfam.h>
#include <libnova/ln_types.h>
#include <libnova/lunar.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <mutex>

#include "almanac/earth_motion.h"

namespace coppermoon::almanac {
namespace {

glm::dvec3 vec(const double* p) { return {p[0], p[1], p[2]}; }

glm::dvec3 geometric_moon98_m(const Instant& instant) {
  double pv[2][3];
  eraMoon98(instant.tt_day, instant.tt_fraction, pv);
  return vec(pv[0]) * astronomical_unit_m;
}

/// Time [days] to add to an instant so that the Moon's mean longitude in ELP 2000-82B agrees with DE405.
double elp_time_shift_days(const Instant& instant) {
  constexpr double mean_motion_arcsec_per_century = 1732559343.736;
  const double t = ((instant.tt_day - ERFA_DJ00) + instant.tt_fraction) / ERFA_DJC;
  const double arcsec = -0.07008 - 0.35106 * t - (0.92010 + 0.03743) * t * t;
  return arcsec / mean_motion_arcsec_per_century * ERFA_DJC;
}

/// Geometric position of the Moon from ELP 2000-82B. libnova expects TDB, and returns kilometres relative to the
/// inertial mean ecliptic and dynamical equinox of J2000.
glm::dvec3 geometric_elp_m(const Instant& instant) {
  ln_rect_posn km{};
  {
    const std::lock_guard lock(libnova_is_single_threaded());
    const double shift = elp_time_shift_days(instant);
    ln_get_lunar_geo_posn(instant.tt_day + (instant.tt_fraction + shift), &km, 0);
  }
  return gcrs_from_ecliptic({km.X * 1e3, km.Y * 1e3, km.Z * 1e3});
}

}  // namespace

EarthMotion earth_at(const Instant& instant) {
  double heliocentric[2][3], barycentric[2][3];
  eraEpv00(instant.tt_day, instant.tt_fraction, heliocentric, barycentric);
  return {vec(heliocentric[0]), vec(barycentric[0]), vec(barycentric[1])};
}

glm::dvec3 aberrated(const glm::dvec3& direction, const EarthMotion& earth) {
  constexpr double au_per_day_in_c = ERFA_AULT / ERFA_DAYSEC;
  const glm::dvec3 v = earth.velocity_au_per_day * au_per_day_in_c;
  double natural[3] = {direction.x, direction.y, direction.z}, velocity[3] = {v.x, v.y, v.z};
  double proper[3];
  eraAb(natural, velocity, glm::length(earth.heliocentric_au), std::sqrt(1 - glm::dot(v, v)),
        proper);
  return vec(proper);
}

std::mutex& libnova_is_single_threaded() {
  static std::mutex one;
  return one;
}

glm::dvec3 gcrs_from_ecliptic(const glm::dvec3& of_2000) {
  double rotation[3][3], ecliptic[3] = {of_2000.x, of_2000.y, of_2000.z}, gcrs[3];
  eraEcm06(ERFA_DJ00, 0, rotation);
  eraTrxp(rotation, ecliptic, gcrs);
  return vec(gcrs);
}

glm::dvec3 apparent_sun_m(const Instant& instant) {
  const EarthMotion earth = earth_at(instant);
  const double light_time_s = glm::length(earth.heliocentric_au) * ERFA_AULT;
  const EarthMotion then = earth_at(later(instant, -light_time_s));
  const glm::dvec3 sun_au = then.barycentric_au - then.heliocentric_au - earth.barycentric_au;
  const double distance_au = glm::length(sun_au);
  return aberrated(sun_au / distance_au, earth) * (distance_au * astronomical_unit_m);
}

glm::dvec3 apparent_moon_m(const Instant& instant, LunarTheory theory) {
  const double light_time_s = glm::length(geometric_moon98_m(instant)) / speed_of_light_m_per_s;
  const Instant then = later(instant, -light_time_s);
  return theory == LunarTheory::moon98 ? geometric_moon98_m(then) : geometric_elp_m(then);
}

}  // namespace coppermoon::almanac
