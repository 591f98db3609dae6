// SPDX-License-Identifier: MIT
#include "uses/fit/night.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "algebra/error.h"
#include "colour/camera.h"
#include "colour/exposure.h"
#include "eclipse/contacts.h"
#include "uses/fit/fit.h"
#include "uses/picture/photo_file.h"

namespace coppermoon::uses {
namespace {

/// Exposure by the request, else by the header; nothing unless complete. With a camera's own tone curve a common
/// factor is free, so an unknown f-number may be any constant.
std::optional<colour::Exposure> exposure_of(const EclipsePhotograph& photograph, bool curved) {
  const auto header = settings_of(photograph.file);
  const auto either = [](const auto& given, const auto& other) { return given ? given : other; };
  const auto time_s = either(photograph.time_s, header.time_s),
             iso = either(photograph.iso, header.iso);
  auto f_number = either(photograph.f_number, header.f_number);
  if (curved && !f_number) f_number = 8;
  if (!time_s || !iso || !f_number) return std::nullopt;
  return colour::Exposure{*time_s, *f_number, *iso};
}

bool is_curved(const EclipsePhotograph& photograph) {
  return coding_of(photograph.file, photograph.coding) == texture::Coding::camera;
}

PhotometricErrors errors_of(const FitRequest& request, const EclipsePhotograph& photograph) {
  constexpr double of_automatic_white_balance = 0.3, of_known_colours = 0.03;
  const bool curved = is_curved(photograph);
  PhotometricErrors errors{
      {},
      request.exposure_error,
      request.white_balance_error.value_or(curved ? of_automatic_white_balance : of_known_colours),
      white_balance_is_fixed(photograph.file)};
  if (curved) {
    // of cameras' matrices some per cent; styles of JPEG saturate colours by 0.8 to 1.3
    errors.mixing_error = 0.03;
    errors.saturation_error = 0.2;
  }
  errors.weather_error = request.weather_error.value_or(curved ? 0.1 : 0);
  if (const auto exposure = exposure_of(photograph, curved))
    errors.value_per_cd_m2 =
        request.camera.empty()
            ? colour::exposure_scale(*exposure)
            : 1 / colour::saturation_cd_m2(colour::camera_named(request.camera), *exposure);
  return errors;
}

/// Light in the air of the least χ².
algebra::Grid<double> light_at(const FittedLight& light, const AirFit& fit) {
  return light.at(fit.best);
}

}  // namespace

Night::Night(const FitRequest& request, std::vector<const EclipsePhotograph*> photographs,
             const algebra::Progress& progress)
    : request_(request),
      heartbeat_([=](double) {
        if (progress) progress(0);
      }),
      photographs_(std::move(photographs)),
      left_out_(photographs_.size()) {
  groundwork_ = std::make_unique<const FitGroundwork>(groundwork_of(request.moon, way()));
  if (request.half_hours_free) find_half_hour();
  std::vector<std::size_t> all(photographs_.size());
  std::iota(all.begin(), all.end(), 0);
  take(clock_s_, all);
  require_any();
  // a shadow at a wrong place shifts a registration by a tenth of that, so registrations are repeated
  constexpr int most_registrations = 3;
  constexpr double near_s = 15;
  for (int made = 0; request.clock_error_s > 0 && made < most_registrations; ++made) {
    const double before_s = clock_s_;
    find_clock();
    if (std::abs(clock_s_ - before_s) < near_s) break;
    take(clock_s_, all);
    require_any();
  }
  light_ = std::make_unique<const FittedLight>(
      night_light(request.moon.light, unknowns_of(request), binned_, instants(clock_s_),
                  request.clock_error_s, FittedAirs::fine, progress));
  compare();
}

std::vector<almanac::SkyState> Night::way() const {
  constexpr double step_s = 300;
  std::vector<almanac::SkyState> skies;
  if (!request_.half_hours_free && request_.clock_error_s == 0) {
    const auto [first, last] =
        std::ranges::minmax(photographs_, [](const auto* one, const auto* other) {
          return almanac::seconds_between(one->instant, other->instant) > 0;
        });
    const double long_s = almanac::seconds_between(first->instant, last->instant);
    for (double s = 0; s < long_s; s += step_s)
      skies.push_back(almanac::sky_at(almanac::later(first->instant, s)));
    skies.push_back(almanac::sky_at(last->instant));
    return skies;
  }
  const auto eclipse =
      eclipse::nearest_eclipse(photographs_.front()->instant, eclipse::ShadowConvention::danjon);
  const auto& [P1, U1, U2, U3, U4, P4] = eclipse.contacts;
  for (double s = 0; s <= almanac::seconds_between(*P1, *P4); s += step_s)
    skies.push_back(almanac::sky_at(almanac::later(*P1, s)));
  return skies;
}

void Night::compare() {
  compared_ = std::make_unique<const ComparedNight>(
      binned_, NightErrors{request_.clock_error_s, curve_, mixing_, expected_});
}

void Night::take_one(double clock_s, std::size_t index) {
  const auto& photograph = *photographs_[index];
  left_out_[index].clear();
  heartbeat_(0);
  try {
    const auto photo = photo_light(photograph.file, photograph.coding, request_.moon.response);
    NightPhotograph known;
    known.scene = fit_scene(request_.moon, *groundwork_, request_.view,
                            almanac::sky_at(almanac::later(photograph.instant, clock_s)));
    const auto registration = registration_of(known.scene, photo);
    const auto curve = is_curved(photograph) ? std::optional(curve_) : std::nullopt;
    known.light = binned(known.scene, photo, registration.render_to_photo, curve);
    known.errors = errors_of(request_, photograph);
    known.errors.place_error_km = place_error_km(known.scene, registration);
    const double px_per_rad = registration.render_to_photo.scale / known.scene.pixel_rad;
    binned_.push_back(std::move(known));
    taken_.push_back({index, registration, {photo.width, photo.height}, px_per_rad});
  } catch (const algebra::Error& error) {
    left_out_[index] = reason_without_name(photograph.file, error);
  }
}

bool Night::at_odds(const Taken& taken) const {
  constexpr double alike = 0.02;
  // scale with the most agreement, by the sum of correlations
  double most = 0, agreed = taken.px_per_rad;
  for (const auto& one : taken_) {
    if (one.extent != taken.extent) continue;
    double sum = 0;
    for (const auto& other : taken_)
      if (other.extent == taken.extent && std::abs(other.px_per_rad / one.px_per_rad - 1) < alike)
        sum += other.registration.correlation;
    if (sum > most) most = sum, agreed = one.px_per_rad;
  }
  return std::abs(taken.px_per_rad / agreed - 1) > alike;
}

void Night::take(double clock_s, std::span<const std::size_t> indices) {
  taken_.clear();
  binned_.clear();
  for (const auto index : indices) take_one(clock_s, index);
  std::vector<std::size_t> odd;
  for (std::size_t place = 0; place < taken_.size(); ++place)
    if (at_odds(taken_[place])) odd.push_back(place);
  std::ranges::reverse(odd);  // what is erased moves what follows
  for (const auto place : odd) {
    left_out_[taken_[place].index] = "a Moon of another size than on the night's other photographs";
    taken_.erase(taken_.begin() + static_cast<std::ptrdiff_t>(place));
    binned_.erase(binned_.begin() + static_cast<std::ptrdiff_t>(place));
  }
}

void Night::require_any() const {
  if (!binned_.empty()) return;
  const auto first = std::ranges::find_if(left_out_, [](const auto& why) { return !why.empty(); });
  throw algebra::Error(fmt::format(
      "{}: {}", photographs_[static_cast<std::size_t>(first - left_out_.begin())]->file, *first));
}

std::vector<almanac::Instant> Night::instants(double clock_s) const {
  std::vector<almanac::Instant> all;
  for (const auto& taken : taken_)
    all.push_back(almanac::later(photographs_[taken.index]->instant, clock_s));
  return all;
}

GoodnessOfFit Night::coarse_fit(double clock_s) const {
  constexpr int aerosols = 16, clouds = 8;
  const auto& [aerosol, cloud, ozone] = unknowns_of(unknowns_of(request_));
  const auto light =
      night_light(request_.moon.light, unknowns_of(request_), binned_, instants(clock_s),
                  request_.clock_error_s, FittedAirs::coarse, heartbeat_);
  const ComparedNight compared(binned_, {request_.clock_error_s, curve_});
  const auto part = [](const Unknown& unknown, double share) {
    return unknown.from_axis(
        std::lerp(unknown.on_axis(unknown.least), unknown.on_axis(unknown.most), share));
  };
  GoodnessOfFit best{std::numeric_limits<double>::infinity()};
  for (int i = 0; i <= aerosols; ++i) {
    const auto at = light.over_cloud(part(aerosol, static_cast<double>(i) / aerosols),
                                     (ozone.least + ozone.most) / 2);
    for (int j = 0; j <= clouds; ++j) {
      const auto found = compared.goodness(at.under(part(cloud, static_cast<double>(j) / clouds)));
      if (found.chi_squared < best.chi_squared) best = found;
    }
  }
  return best;
}

void Night::find_half_hour() {
  constexpr double half_hour_s = 1800;
  constexpr int farthest = 52;  // zones are 26 hours apart
  constexpr std::size_t enough = 3;
  const auto last = photographs_.size() - 1, count = std::min(enough, photographs_.size());
  std::vector<std::size_t> some{0};
  for (std::size_t i = 1; i < count; ++i) some.push_back(i * last / (count - 1));
  const auto contacts =
      eclipse::nearest_eclipse(photographs_.front()->instant, eclipse::ShadowConvention::danjon)
          .contacts;
  double most = 0;
  for (int step = -farthest; step <= farthest; ++step) {
    const double clock_s = step * half_hour_s;
    const bool all_eclipsed = std::ranges::all_of(photographs_, [&](const auto* photograph) {
      const auto moment = almanac::later(photograph->instant, clock_s);
      return almanac::seconds_between(*contacts.P1, moment) > 0 &&
             almanac::seconds_between(moment, *contacts.P4) > 0;
    });
    if (!all_eclipsed) continue;
    take(clock_s, some);
    double alike = 0;  // the better, the nearer the shadow is to its place on the photographs
    for (const auto& taken : taken_) alike += taken.registration.correlation;
    if (alike > most) most = alike, clock_s_ = clock_s;
  }
  if (most == 0)
    throw algebra::Error(
        "no zone and clock explain the photographs' dates: allowed are those of an eclipse");
}

void Night::find_clock() {
  constexpr int most_looks = 8;
  constexpr double near_s = 20;
  for (int look = 0; look < most_looks; ++look) {
    const double further_s = std::clamp(coarse_fit(clock_s_).clock_s, -300., 300.);
    clock_s_ += further_s;
    if (std::abs(further_s) < near_s) return;
  }
}

DataSet Night::data() const {
  return {light_.get(),
          [this](const algebra::Grid<double>& light) { return compared_->goodness(light); },
          compared_->count()};
}

bool Night::curved() const {
  return std::ranges::any_of(binned_, [](const auto& one) { return !one.light.slopes.empty(); });
}

bool Night::refine(const AirFit& fit) {
  if (!curved()) return false;
  expected_ = light_at(*light_, fit);
  const auto curve = compared_->curve(expected_);
  mixing_ = compared_->mixing(expected_);
  curve_ = curve;
  for (std::size_t place = 0; place < taken_.size(); ++place) {
    auto& known = binned_[place];
    if (known.light.slopes.empty()) continue;
    const auto& [index, registration, extent, px_per_rad] = taken_[place];
    const auto photo =
        photo_light(photographs_[index]->file, photographs_[index]->coding, request_.moon.response);
    known.light = binned(known.scene, photo, registration.render_to_photo, curve_);
  }
  compare();
  return true;
}

colour::ToneCurve Night::curve(const AirFit& fit) const {
  return compared_->curve(light_at(*light_, fit));
}

std::vector<MeasuredLight> Night::measured(const AirFit& fit) const {
  return compared_->measured(light_at(*light_, fit));
}

std::vector<ReadPhotograph> Night::read() const {
  std::vector<ReadPhotograph> all(photographs_.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i].left_out = left_out_[i];
  for (std::size_t place = 0; place < taken_.size(); ++place) {
    const auto& taken = taken_[place];
    all[taken.index] = {taken.registration,
                        binned_[place].errors.value_per_cd_m2.has_value(),
                        compared_->count_of(place),
                        !binned_[place].light.slopes.empty(),
                        {}};
  }
  return all;
}

}  // namespace coppermoon::uses
