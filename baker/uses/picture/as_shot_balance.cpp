// SPDX-License-Identifier: MIT
#include "uses/picture/as_shot_balance.h"

#include <algorithm>
#include <exiv2/exiv2.hpp>
#include <map>

namespace coppermoon::uses {
namespace {

using Gains = std::array<double, 3>;

/// Where the gains of red, green, green and blue stand in Canon's colour data, by the length of these data.
const std::map<std::size_t, std::size_t> canon_first_gain{
    {582, 25},  {653, 24},  {674, 63},   {692, 63},   {702, 63},  {796, 63},
    {1227, 63}, {1250, 63}, {1251, 63},  {1273, 63},  {1275, 63}, {1312, 63},
    {1313, 63}, {1316, 63}, {1337, 63},  {1338, 63},  {1353, 63}, {1506, 63},
    {1560, 63}, {1592, 63}, {1602, 63},  {1816, 71},  {1820, 71}, {1824, 71},
    {2024, 85}, {3656, 85}, {3778, 105}, {3973, 105}, {4528, 105}};

Gains over_green(double red, double green, double blue) { return {red / green, 1, blue / green}; }

std::optional<Gains> gains_in(const Exiv2::ExifData& header) {
  if (const auto nikon = header.findKey(Exiv2::ExifKey("Exif.Nikon3.WB_RBLevels"));
      nikon != header.end() && nikon->count() >= 2)
    return over_green(nikon->toFloat(0), 1, nikon->toFloat(1));
  const auto canon = header.findKey(Exiv2::ExifKey("Exif.Canon.ColorData"));
  if (canon == header.end()) return std::nullopt;
  const auto first = canon_first_gain.find(static_cast<std::size_t>(canon->count()));
  if (first == canon_first_gain.end()) return std::nullopt;
  const auto at = [&](std::size_t i) {
    return canon->toFloat(static_cast<long>(first->second + i));
  };
  return over_green(at(0), at(1), at(3));
}

}  // namespace

std::optional<Gains> as_shot_balance(const std::string& photo) try {
  constexpr double least = 0.1, most = 10;
  Exiv2::LogMsg::setLevel(Exiv2::LogMsg::mute);
  const auto image = Exiv2::ImageFactory::open(photo);
  image->readMetadata();
  const auto gains = gains_in(image->exifData());
  const auto sound = [](double gain) { return gain >= least && gain <= most; };
  return gains && std::ranges::all_of(*gains, sound) ? gains : std::nullopt;
} catch (const Exiv2::Error&) {  // not a photograph with a header
  return std::nullopt;
}

}  // namespace coppermoon::uses
