// SPDX-License-Identifier: MIT
#include "verbs/reports/in_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace coppermoon::verbs {
namespace {

/// A number rounded to the given number of significant digits, without an exponent.
std::string plain(double number, int digits) {
  const double rounded = std::stod(fmt::format("{:.{}e}", number, digits - 1));
  if (rounded == 0) return "0";
  const int decimals = digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(rounded))));
  auto text = fmt::format("{:.{}f}", rounded, std::max(0, decimals));
  if (decimals > 0) text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

/// A number rounded to two significant digits, such as "1200" or "0.31".
std::string two_digits(double number) { return plain(number, 2); }

}  // namespace

std::string three_digits(double number) { return plain(number, 3); }

std::string in_percent(double share) { return two_digits(100 * share) + " %"; }

std::string within(double relative_error) {
  if (!(relative_error < 1)) return "in places wrong by more than the light itself";
  return "within " + (relative_error < 1e-5 ? "0.001 %" : in_percent(relative_error));
}

std::string duration(double seconds) {
  constexpr double minute = 60, hour = 3600, day = 24 * hour, year = 365.25 * day;
  if (seconds < 90) return two_digits(seconds) + " s";
  if (seconds < 90 * minute) return two_digits(seconds / minute) + " min";
  if (seconds < 48 * hour) return two_digits(seconds / hour) + " h";
  if (seconds < year) return two_digits(seconds / day) + " days";
  return two_digits(seconds / year) + " years";
}

std::string exposure_in_words(double seconds) {
  if (seconds < 0.4 && seconds > 0) return "1/" + two_digits(1 / seconds) + " s";
  return two_digits(seconds) + " s";
}

std::string exposure_in_words(const uses::Exposures& exposures) {
  const auto shorter = exposure_in_words(exposures.shorter.time_s);
  return exposures.longer_s ? shorter + " and " + exposure_in_words(*exposures.longer_s) : shorter;
}

std::string bright_sky_in_words(double sky_over_moon) {
  return fmt::format(
      "the sky is {} times as bright as the Moon, which hardly shows; --sky off leaves it out",
      two_digits(sky_over_moon));
}

std::optional<std::string> unseen_in_words(const uses::Circumstances& night,
                                           const almanac::Instant& when) {
  if (is_seen(night, when)) return std::nullopt;
  std::string line = "the Moon cannot be seen in its sky";
  for (const auto& [from, to] : night.seen)
    if (almanac::seconds_between(when, from) > 0)
      return line + fmt::format("; it can from {}", almanac::utc_text(from));
  return night.seen.empty() ? line + " at any time of this eclipse"
                            : line + fmt::format("; it could until {}",
                                                 almanac::utc_text(night.seen.back().second));
}

std::string in_words(const colour::ToneCurve& curve) {
  return fmt::format("{:+.2f} standard deviations of cameras",
                     fmt::join(components_of(curve), ", "));
}

std::string doubt_of(const colour::ToneCurve& curve) {
  constexpr double most_deviations = 4;  // exceeded by only one camera in ten thousand
  double most = 0;
  for (const double number : components_of(curve))
    if (std::abs(number) > std::abs(most)) most = number;
  if (std::abs(most) <= most_deviations) return {};
  return fmt::format(
      "no camera has the tone curve that was found, {:+.0f} standard deviations from their mean: "
      "likely another moment or air, or no camera's JPEG (--coding srgb or linear)",
      most);
}

std::vector<double> components_of(const colour::ToneCurve& curve) {
  return {curve.numbers.begin(), curve.numbers.begin() + colour::tone_components};
}

}  // namespace coppermoon::verbs
