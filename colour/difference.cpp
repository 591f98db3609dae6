// SPDX-License-Identifier: MIT
#include "colour/difference.h"

#include <cmath>
#include <glm/matrix.hpp>
#include <numbers>

#include "algebra/error.h"
#include "colour/srgb.h"
#include "colour/working_space.h"

namespace coppermoon::colour {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

constexpr double radians(double degrees) { return degrees * std::numbers::pi / 180; }

double cube_root_or_line(double t) {
  constexpr double knee = 6. / 29;
  return t > knee * knee * knee ? std::cbrt(t) : t / (3 * knee * knee) + 4. / 29;
}

double decoded(float coded) {
  algebra::require_within("sRGB channel", coded, 0, 1);
  return srgb_light(coded);
}

/// Vividness of a colour with chroma C, √(C⁷ / (C⁷ + 25⁷)): 0 for greys, near 1 for vivid colours.
double vividness(double chroma) {
  const double power = std::pow(chroma, 7);
  return std::sqrt(power / (power + std::pow(25., 7)));
}

/// A colour after CIEDE2000 has stretched its a* axis: L', C' and h' in Sharma et al. (2005).
struct Stretched {
  double L, a, b, chroma;
  double hue;  ///< 0 to 2π [rad]; 0 for a grey
};

Stretched stretched(const Lab& colour, double stretch) {
  const double a = stretch * colour.a, hue = std::atan2(colour.b, a);
  return {colour.L, a, colour.b, std::hypot(a, colour.b), hue < 0 ? hue + full_turn : hue};
}

/// Signed angle from one hue to another, the shorter way round. Between opposite hues, the way that avoids 0 is taken.
double hue_turn(const Stretched& one, const Stretched& other) {
  const double across = one.a * other.b - other.a * one.b,
               along = one.a * other.a + one.b * other.b;
  if (across == 0 && along < 0) return other.hue > one.hue ? full_turn / 2 : -full_turn / 2;
  return std::atan2(across, along);
}

double mean_hue(const Stretched& one, const Stretched& other, double turn) {
  if (one.chroma == 0 || other.chroma == 0) return one.hue + other.hue;
  const double hue = one.hue + turn / 2;
  return hue < 0 ? hue + full_turn : std::fmod(hue, full_turn);
}

/// T in Sharma et al. (2005): how sensitivity to hue depends on hue.
double hue_weight(double hue) {
  return 1 - 0.17 * std::cos(hue - radians(30)) + 0.24 * std::cos(2 * hue) +
         // FAULT CIEDE2000's weight of hue: radians(63) => radians(-63)
         0.32 * std::cos(3 * hue + radians(6)) - 0.20 * std::cos(4 * hue - radians(63));
}

/// R_T in Sharma et al. (2005): interaction of chroma and hue differences in blues.
double blue_rotation(double chroma, double hue) {
  const double from_blue = (hue - radians(275)) / radians(25);
  return -2 * vividness(chroma) * std::sin(radians(60) * std::exp(-from_blue * from_blue));
}

/// S_L in Sharma et al. (2005): divisor of the lightness difference.
double lightness_weight(double L) {
  const double squared = (L - 50) * (L - 50);
  return 1 + 0.015 * squared / std::sqrt(20 + squared);
}

}  // namespace

Lab lab_from_xyz(const glm::dvec3& xyz) {
  static const glm::dvec3 white =
      glm::inverse(channels_from_xyz(WorkingSpace::linear_rec709)) * glm::dvec3(1);
  const double x = cube_root_or_line(xyz.x / white.x), y = cube_root_or_line(xyz.y),
               z = cube_root_or_line(xyz.z / white.z);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Lab lab_from_srgb(const Rgb& coded) {
  static const auto xyz_from_rgb = glm::inverse(channels_from_xyz(WorkingSpace::linear_rec709));
  return lab_from_xyz(xyz_from_rgb *
                      glm::dvec3(decoded(coded[0]), decoded(coded[1]), decoded(coded[2])));
}

double delta_e_2000(const Lab& one, const Lab& other) {
  const double plain_chroma = (std::hypot(one.a, one.b) + std::hypot(other.a, other.b)) / 2;
  const double stretch = 1 + 0.5 * (1 - vividness(plain_chroma));
  const auto first = stretched(one, stretch), second = stretched(other, stretch);
  const double turn = hue_turn(first, second), hue = mean_hue(first, second, turn);
  const double chroma = (first.chroma + second.chroma) / 2;
  const double l = (second.L - first.L) / lightness_weight((first.L + second.L) / 2);
  const double c = (second.chroma - first.chroma) / (1 + 0.045 * chroma);
  const double h = 2 * std::sqrt(first.chroma * second.chroma) * std::sin(turn / 2) /
                   (1 + 0.015 * chroma * hue_weight(hue));
  return std::sqrt(l * l + c * c + h * h + blue_rotation(chroma, hue) * c * h);
}

}  // namespace coppermoon::colour
