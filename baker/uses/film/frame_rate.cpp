// SPDX-License-Identifier: MIT
#include "uses/film/frame_rate.h"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "algebra/error.h"
#include "algebra/number.h"
#include "uses/light/shard.h"

namespace coppermoon::uses {
namespace {

constexpr double least = 1, most = 1000;
constexpr int most_below = 10000, television = 1001, thousand = 1000;

FrameRate reduced(int over, int under) {
  const int common = std::gcd(over, under);
  return {over / common, under / common};
}

/// Ratio of a decimal number. Television's rates are 1000/1001 of multiples of 12 and 15, written to two or three
/// decimals.
FrameRate ratio_of(double number) {
  constexpr double written_within = 0.005;
  const long whole = std::lround(number * television / thousand);
  const bool is_whole = number == std::round(number),
             near = std::abs(number - static_cast<double>(whole) * thousand / television) <
                    written_within;
  if (!is_whole && near && (whole % 12 == 0 || whole % 15 == 0))
    return reduced(static_cast<int>(whole) * thousand, television);
  return reduced(static_cast<int>(std::lround(number * thousand)), thousand);
}

}  // namespace

FrameRate frame_rate_from(const std::string& text) {
  const auto slash = text.find('/');
  if (slash == std::string::npos) {
    const auto number = algebra::number_in(text);
    if (!number)
      throw algebra::Error(
          fmt::format("fps = {}, allowed 1 to 1000, as 24, 23.976 or 24000/1001", text));
    algebra::require_within("fps", *number, least, most);
    return ratio_of(*number);
  }
  const auto over = whole_number(text.substr(0, slash)),
             under = whole_number(text.substr(slash + 1));
  const bool sound = over && under && *under >= 1 && *under <= most_below && *over >= *under &&
                     *over <= thousand * *under;
  if (!sound)
    throw algebra::Error(fmt::format(
        "fps = {}, allowed 1 to 1000, a ratio of whole numbers with 1 to 10000 below", text));
  return reduced(static_cast<int>(*over), static_cast<int>(*under));
}

std::string text_of(const FrameRate& rate) {
  return thousand % rate.seconds == 0 ? fmt::format("{}", rate.value())
                                      : fmt::format("{}/{}", rate.frames, rate.seconds);
}

void read_text(const std::string& text, FrameRate& rate) { rate = frame_rate_from(text); }

}  // namespace coppermoon::uses
