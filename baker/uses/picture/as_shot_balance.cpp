// SPDX-License-Identifier: MIT
#include "uses/picture/as_shot_balance.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

#include "uses/picture/photo_header.h"

namespace coppermoon::uses {
namespace {

using Gains = std::array<double, 3>;

/// Index of the first of the four gains (red, green, green, blue) in Canon's ColorData, by the number of values in it.
const std::map<std::size_t, std::size_t> canon_first_gain{
    {582, 25},  {653, 24},  {674, 63},   {692, 63},   {702, 63},  {796, 63},
    {1227, 63}, {1250, 63}, {1251, 63},  {1273, 63},  {1275, 63}, {1312, 63},
    {1313, 63}, {1316, 63}, {1337, 63},  {1338, 63},  {1353, 63}, {1506, 63},
    {1560, 63}, {1592, 63}, {1602, 63},  {1816, 71},  {1820, 71}, {1824, 71},
    {2024, 85}, {3656, 85}, {3778, 105}, {3973, 105}, {4528, 105}};

Gains over_green(double red, double green, double blue) { return {red / green, 1, blue / green}; }

/// Numbers in a string, such as "468/256 406/256" or "1542 1024".
std::vector<double> numbers_in(const std::string& text) {
  std::vector<double> all;
  std::istringstream words(text);
  for (std::string word; words >> word;) all.push_back(first_number(word).value_or(0));
  return all;
}

std::optional<Gains> gains_in(const PhotoHeader& header) {
  if (const auto nikon = header.find("WB_RBLevels"); nikon != header.end()) {
    const auto gains = numbers_in(nikon->second);
    if (gains.size() >= 2) return over_green(gains[0], 1, gains[1]);
  }
  const auto canon = header.find("ColorData");
  if (canon == header.end()) return std::nullopt;
  const auto data = numbers_in(canon->second);
  const auto first = canon_first_gain.find(data.size());
  if (first == canon_first_gain.end()) return std::nullopt;
  const auto at = [&](std::size_t i) { return data[first->second + i]; };
  return over_green(at(0), at(1), at(3));
}

}  // namespace

std::optional<Gains> as_shot_balance(const std::string& photo) {
  constexpr double least = 0.1, most = 10;
  const auto gains = gains_in(photo_header(photo));
  const auto sound = [](double gain) { return gain >= least && gain <= most; };
  return gains && std::ranges::all_of(*gains, sound) ? gains : std::nullopt;
}

}  // namespace coppermoon::uses
