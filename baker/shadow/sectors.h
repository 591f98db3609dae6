// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>

namespace coppermoon::shadow {

/// Default number of sectors for light that is not symmetric about the axis.
inline constexpr std::size_t sectors_around = 24;

/// Consecutive sectors of position angle about the shadow axis: `count` of them, from number `first` on. The circle has
/// `around` equal sectors, numbered from 0 in the north through east. Sector s is centred at 2π s / around.
struct Sectors {
  std::size_t around = 1;  ///< number of sectors in the full circle, 1 or more
  std::size_t first = 0, count = around;

  bool operator==(const Sectors&) const = default;

  bool all() const { return count >= around; }

  /// Number of the i-th of these sectors, counted in the full circle.
  std::size_t operator[](std::size_t i) const { return (first + i) % around; }

  /// The number of a sector, wrapped into the range from 0 to around − 1.
  std::size_t wrapped(std::ptrdiff_t number) const {
    const auto size = static_cast<std::ptrdiff_t>(around);
    return static_cast<std::size_t>((number % size + size) % size);
  }

  /// Whether these sectors include a given one.
  bool hold(std::size_t part) const { return (part + around - first) % around < count; }

  /// Position angle of a sector's middle, 0 to 2π.
  double angle_rad(std::size_t part) const {
    return 2 * std::numbers::pi * static_cast<double>(part) / static_cast<double>(around);
  }

  /// Sector that contains a position angle.
  std::size_t nearest(double angle_rad) const {
    const double turn = angle_rad / (2 * std::numbers::pi) * static_cast<double>(around);
    return wrapped(static_cast<std::ptrdiff_t>(std::floor(turn + 0.5)));
  }

  /// Sector on the opposite side of the axis, or the sector itself if the number of sectors is odd.
  std::size_t opposite(std::size_t part) const {
    return around % 2 == 0 ? (part + around / 2) % around : part;
  }

  /// Mirror image of a sector about celestial north.
  std::size_t mirrored(std::size_t part) const { return (around - part) % around; }

  /// These sectors and one more on either side.
  Sectors widened() const {
    return count + 2 >= around ? Sectors{around}
                               : Sectors{around, (first + around - 1) % around, count + 2};
  }

  /// These sectors if `around` equals `parts`. Otherwise, all sectors of a circle that is divided into `parts` sectors.
  Sectors in(std::size_t parts) const { return parts == around ? *this : Sectors{parts}; }
};

/// Sectors whose middles enclose an interval of position angles.
///
/// Given  from_rad, to_rad  from < to
inline Sectors between_angles(std::size_t around, double from_rad, double to_rad) {
  const double a_part = 2 * std::numbers::pi / static_cast<double>(around);
  const auto from = static_cast<std::ptrdiff_t>(std::floor(from_rad / a_part)),
             to = static_cast<std::ptrdiff_t>(std::ceil(to_rad / a_part));
  const auto count = static_cast<std::size_t>(to - from + 1);
  return {around, Sectors{around}.wrapped(from), count < around ? count : around};
}

}  // namespace coppermoon::shadow
