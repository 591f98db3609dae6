// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>

namespace coppermoon::shadow {

/// Parts of all position angles that light is given in where it differs around the axis.
inline constexpr std::size_t sectors_around = 24;

/// Some of the equal parts of all position angles about the shadow axis, going round from the first through
/// east. Part s is centred at 2π s / around.
struct Sectors {
  std::size_t around = 1;  ///< parts of all position angles, 1 or more
  std::size_t first = 0, count = around;

  bool operator==(const Sectors&) const = default;

  bool all() const { return count >= around; }

  /// Part that stands i places after the first.
  std::size_t operator[](std::size_t i) const { return (first + i) % around; }

  /// Part of a number that goes round beyond the last, or backwards beyond the first.
  std::size_t wrapped(std::ptrdiff_t number) const {
    const auto size = static_cast<std::ptrdiff_t>(around);
    return static_cast<std::size_t>((number % size + size) % size);
  }

  /// Whether a part is one of these.
  bool hold(std::size_t part) const { return (part + around - first) % around < count; }

  /// Position angle of a part's middle, 0 to 2π.
  double angle_rad(std::size_t part) const {
    return 2 * std::numbers::pi * static_cast<double>(part) / static_cast<double>(around);
  }

  /// Part that a position angle lies in.
  std::size_t nearest(double angle_rad) const {
    const double turn = angle_rad / (2 * std::numbers::pi) * static_cast<double>(around);
    return wrapped(static_cast<std::ptrdiff_t>(std::floor(turn + 0.5)));
  }

  /// Part on the other side of the axis; the part itself where none is opposite.
  std::size_t opposite(std::size_t part) const {
    return around % 2 == 0 ? (part + around / 2) % around : part;
  }

  /// Part at the same angle on the other side of celestial north.
  std::size_t mirrored(std::size_t part) const { return (around - part) % around; }

  /// Sectors with one more on either side.
  Sectors widened() const {
    return count + 2 >= around ? Sectors{around}
                               : Sectors{around, (first + around - 1) % around, count + 2};
  }

  /// Themselves where all position angles make so many parts; else all of those.
  Sectors in(std::size_t parts) const { return parts == around ? *this : Sectors{parts}; }
};

/// Parts from the one that the first angle is in, or ends before it, to the one that ends behind the other.
///
/// Given  from_rad, to_rad  rising
inline Sectors between_angles(std::size_t around, double from_rad, double to_rad) {
  const double a_part = 2 * std::numbers::pi / static_cast<double>(around);
  const auto from = static_cast<std::ptrdiff_t>(std::floor(from_rad / a_part)),
             to = static_cast<std::ptrdiff_t>(std::ceil(to_rad / a_part));
  const auto count = static_cast<std::size_t>(to - from + 1);
  return {around, Sectors{around}.wrapped(from), count < around ? count : around};
}

}  // namespace coppermoon::shadow
