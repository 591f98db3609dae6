// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "almanac/instant.h"

namespace coppermoon::almanac {

/// A fixed star.
struct Star {
  std::uint32_t hipparcos;              ///< number in that catalogue; 0: of another
  glm::dvec3 place;                     ///< at 2000.0, ICRS axes, unit
  double magnitude, b_minus_v;          ///< V; B − V
  glm::dvec3 motion_per_year{0, 0, 0};  ///< proper motion, across the place [radians]
};

/// The stars of one of Stellarium's catalogues: stars_0_0v0_8.cat to V = 6, stars_1_0v0_8.cat to 7.5,
/// stars_2_0v0_8.cat to 9.
///
/// A catalogue divides the sky into the 20·4ⁿ triangles of an icosahedron whose edges are halved n
/// times; a star stands on the plane that touches the sphere in its triangle's middle.
///
/// Given     bytes  of the file;  name: of the file, for errors
/// Accuracy  0.02″ of Hipparcos in place, 0.05 in magnitude, 0.03 in B − V: the steps of the file
/// Omits     proper motion, which strays in these files by a fifth from Hipparcos'
/// Throws    Error  when they are no such catalogue, of another version, or cut off
std::vector<Star> stars_in(std::string_view bytes, const std::string& name);

/// Gives stars their proper motions from a table by Hipparcos' numbers, as Stellarium's hip_pm.dat.
///
/// Given   text  a line for each star: number, motion east and north [mas a year]; # begins a comment
/// Throws  Error  when a line is no such line
void add_proper_motions(std::vector<Star>& stars, std::string_view text, const std::string& name);

/// Where the Earth's centre sees them: proper motion and aberration included.
///
/// Returned  unit, GCRS axes, in the order of the stars
/// Accuracy  0.01″ of ERFA's own way, within 1000 years of 2000
/// Omits     parallax; the Sun's gravity, which bends light near the Sun alone
std::vector<glm::dvec3> apparent_directions(const std::vector<Star>& stars, const Instant& instant);

}  // namespace coppermoon::almanac
