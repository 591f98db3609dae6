// SPDX-License-Identifier: MIT
#include "uses/fit/night.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "algebra/error.h"
#include "colour/camera.h"
#include "colour/exposure.h"
#include "eclipse/contacts.h"
#include "uses/fit/fit.h"

namespace coppermoon::uses {
namespace {

constexpr double half_hour_s = 1800;

/// Exposure by the request, else by the header; nothing unless complete. Where a common factor is free an unknown
/// f-number may be any constant, and so may the ISO speed of a camera that has a gain in its place.
std::optional<colour::Exposure> exposure_of(const EclipsePhotograph& photograph, bool free) {
  const auto header = settings_of(photograph.file);
  const auto either = [](const auto& given, const auto& other) { return given ? given : other; };
  const auto time_s = either(photograph.time_s, header.time_s);
  auto iso = either(photograph.iso, header.iso),
       f_number = either(photograph.f_number, header.f_number);
  if (free && !f_number) f_number = 8;
  if (free && !iso && header.gain) iso = 100;
  if (!time_s || !iso || !f_number) return std::nullopt;
  return colour::Exposure{*time_s, *f_number, *iso};
}

bool is_curved(const EclipsePhotograph& photograph) {
  return coding_of(photograph.file, photograph.coding) == texture::Coding::camera;
}

/// Whether exposures tell light by a common factor alone: of a sensor's counts, or where a gain stands for the ISO speed.
bool is_relative(const EclipsePhotograph& photograph, const std::optional<ClippedAt>& clipped) {
  const auto header = settings_of(photograph.file);
  return clipped || (header.gain && !photograph.iso && !header.iso);
}

PhotometricErrors errors_of(const FitRequest& request, const EclipsePhotograph& photograph,
                            const std::optional<ClippedAt>& clipped) {
  constexpr double of_automatic_white_balance = 0.3, of_known_colours = 0.03;
  constexpr double of_exposures = 0.1, free = 10;
  const bool curved = is_curved(photograph);
  PhotometricErrors errors{
      {},
      request.exposure_error.value_or(curved || is_relative(photograph, clipped) ? free
                                                                                 : of_exposures),
      request.shutter_error,
      request.white_balance_error.value_or(curved ? of_automatic_white_balance : of_known_colours),
      white_balance_is_fixed(photograph.file)};
  // of cameras' matrices some per cent; that of a raw file is known with its filters
  const bool raw = texture::is_raw_file(photograph.file);
  if (curved || (raw && !request.moon.response)) errors.mixing_error = 0.03;
  if (curved) errors.saturation_error = 0.2;  // styles of JPEG saturate colours by 0.8 to 1.3
  errors.weather_error = request.weather_error.value_or(curved || raw ? 0.1 : 0);
  if (const auto exposure = exposure_of(photograph, errors.exposure_error >= free))
    errors.value_per_cd_m2 =
        request.camera.empty()
            ? colour::exposure_scale(*exposure)
            : 1 / colour::saturation_cd_m2(colour::camera_named(request.camera), *exposure);
  if (errors.value_per_cd_m2 && clipped) *errors.value_per_cd_m2 /= clipped->light;
  return errors;
}

/// Whether two scales are of one lens.
bool is_alike(double one, double other) {
  constexpr double alike = 0.02;
  return std::abs(one / other - 1) < alike;
}

/// Whether two pictures are turned by angles less than 30 degrees apart, and mirrored alike.
bool are_turned_alike(const colour::Similarity& one, const colour::Similarity& other) {
  const double least_cosine = std::sqrt(0.75);
  return one.mirrored == other.mirrored &&
         std::cos(one.rotation_rad - other.rotation_rad) > least_cosine;
}

/// Light in the air of the least χ².
algebra::Grid<double> light_at(const FittedLight& light, const AirFit& fit) {
  return light.at(fit.best);
}

/// Relative change of cloud for the derivative of light.
constexpr double more_cloud = 0.1;

constexpr int most_curves_read = 2;

/// Whether cloud is a chance, of which a fit knows the logarithm.
bool cloud_is_a_chance(const AirFit& fit) { return unknowns_of(fit.unknowns)[1].logarithmic; }

/// Numbers of an air with more cloud than the best.
AirNumbers clouded_numbers(const AirFit& fit) {
  auto numbers = fit.best;
  numbers[1] = cloud_is_a_chance(fit) ? numbers[1] * (1 + more_cloud)
                                      : numbers[1] + more_cloud * (1 - numbers[1]);
  return numbers;
}

}  // namespace

Night::Night(const FitRequest& request, std::vector<const EclipsePhotograph*> photographs,
             const algebra::Progress& progress)
    : request_(request),
      heartbeat_([=](double) {
        if (progress) progress(0);
      }),
      photographs_(std::move(photographs)),
      kept_(photographs_.size()),
      left_out_(photographs_.size()),
      clock_error_s_(request.clock_error_s) {
  groundwork_ = std::make_unique<const FitGroundwork>(
      groundwork_of(request.moon, way(), request.response_assumed));
  if (clock_is_free()) scan_clock();
  clock_scanned_ = true;
  const auto all = some(photographs_.size());
  const auto look = [&] {
    take(clock_s_, all);
    require_any();
    read_light();
    leave_out_misplaced();
  };
  look();
  // a shadow at a wrong place shifts a registration by a tenth of that, so registrations are repeated
  constexpr int most_registrations = 3;
  constexpr double near_s = 15;
  for (int made = 0; clock_error_s_ > 0 && made < most_registrations; ++made) {
    const double before_s = clock_s_;
    find_clock();
    if (std::abs(clock_s_ - before_s) < near_s) break;
    look();
  }
  compute_light(progress);
  compare();
}

void Night::compute_light(const algebra::Progress& progress, const std::optional<AirRange>& range) {
  light_ = std::make_unique<const FittedLight>(
      night_light(request_.moon.light, unknowns_of(request_), binned_, instants(clock_s_),
                  clock_error_s_, FittedAirs::fine, progress, range));
}

std::vector<almanac::SkyState> Night::way() const {
  constexpr double step_s = 300;
  std::vector<almanac::SkyState> skies;
  if (!clock_is_free() && clock_error_s_ == 0) {
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

double Night::farthest_clock_s() const {
  constexpr double linear_s = 300, errors = 3;  // of light beside a moment
  const double error_s = request_.clock_error_s;
  return std::max(request_.clock_search_s, error_s > linear_s ? errors * error_s : 0);
}

bool Night::clock_is_free() const { return request_.half_hours_free || farthest_clock_s() > 0; }

NightErrors Night::errors() const {
  return {clock_error_s_, believed_s_ - clock_s_, curve_, mixing_, expected_, clouded_,
          clouded_by_};
}

void Night::compare() { compared_ = std::make_unique<const ComparedNight>(binned_, errors()); }

const Night::Kept& Night::kept(std::size_t index) {
  auto& kept = kept_[index];
  if (!kept) try {
      const auto& photograph = *photographs_[index];
      auto photo = photo_light(photograph.file, photograph.coding, request_.moon.response);
      kept = Kept{{}, {photo.width, photo.height}};
      kept->clipped_at = clipped_at(photograph.file, photo);
      if (kept->clipped_at)
        for (float& value : photo.values) value /= static_cast<float>(kept->clipped_at->light);
      kept->moon = moon_part(photo);
    } catch (const algebra::Error& error) {
      if (!kept) kept.emplace();
      kept->unusable = reason_without_name(photographs_[index]->file, error);
    }
  return *kept;
}

void Night::take_one(double clock_s, std::size_t index, std::optional<double> px_per_rad,
                     bool roughly) {
  const auto& photograph = *photographs_[index];
  const auto& [moon, extent, unusable, clipped] = kept(index);
  left_out_[index] = unusable;
  if (!unusable.empty()) return;
  heartbeat_(0);
  try {
    NightPhotograph known;
    known.scene = fit_scene(request_.moon, *groundwork_, request_.view,
                            almanac::sky_at(almanac::later(photograph.instant, clock_s)));
    const double px_per_scale = moon.shrunk / known.scene.pixel_rad;
    if (px_per_rad) *px_per_rad /= px_per_scale;
    const auto how = roughly          ? Registering::rough
                     : clock_scanned_ ? Registering::of_clipped
                                      : Registering::fine;
    const auto registration = registration_of(known.scene, moon, px_per_rad, how);
    known.errors = errors_of(request_, photograph, clipped);
    binned_.push_back(std::move(known));
    taken_.push_back({index, registration, registration.render_to_photo.scale * px_per_scale});
  } catch (const algebra::Error& error) {
    left_out_[index] = reason_with_shares(moon, reason_without_name(photograph.file, error));
  }
}

void Night::read_light() {
  for (std::size_t place = 0; place < taken_.size(); ++place) {
    const auto& [index, registration, px_per_rad] = taken_[place];
    auto& [scene, light, errors] = binned_[place];
    const auto curve = is_curved(*photographs_[index]) ? std::optional(curve_) : std::nullopt;
    if (scene.glow.empty()) scene.glow = glow_of(scene);
    light = binned(scene, kept(index).moon, registration.render_to_photo, curve);
    errors.place_error_km = place_error_km(scene, registration, registered_in_best_air_);
  }
}

double Night::agreed_px_per_rad(std::size_t index) {
  const auto sized = [&](const Taken& taken) {
    return kept(taken.index).extent == kept(index).extent;
  };
  double most = 0, agreed = 0;
  for (const auto& one : taken_) {
    if (!sized(one)) continue;
    double sum = 0, scales = 0;
    for (const auto& other : taken_)
      if (sized(other) && is_alike(other.px_per_rad, one.px_per_rad)) {
        sum += other.registration.correlation;
        scales += other.registration.correlation * other.px_per_rad;
      }
    if (sum > most) most = sum, agreed = scales / sum;
  }
  return agreed;
}

void Night::take_in_scale(double clock_s, std::size_t index, double px_per_rad) {
  constexpr double as_well = 0.9, well = 0.8;
  const auto erase = [&] {
    const auto at = std::ranges::find(taken_, index, &Taken::index);
    if (at == taken_.end()) return 0.;
    const double correlation = at->registration.correlation;
    binned_.erase(binned_.begin() + (at - taken_.begin()));
    taken_.erase(at);
    return correlation;
  };
  const double alike = erase();
  const auto why = left_out_[index];
  take_one(clock_s, index, px_per_rad, false);
  const double in_scale = left_out_[index].empty() ? taken_.back().registration.correlation : 0;
  if (in_scale >= std::max(well, as_well * alike)) return;
  erase();
  if (alike >= well)
    left_out_[index] = reason_with_shares(
        kept(index).moon,
        "a Moon that looks of another size than on the night's other photographs: by a zoom, or by "
        "the glow of a clipped limb");
  else if (in_scale > 0)
    left_out_[index] = reason_with_shares(
        kept(index).moon,
        fmt::format(
            "correlation of photograph and Moon in the others' scale = {:.2f}, allowed {} to 1",
            in_scale, well));
  else if (!why.empty())
    left_out_[index] = why;
}

void Night::take(double clock_s, std::span<const std::size_t> indices, bool roughly) {
  taken_.clear();
  binned_.clear();
  for (const auto index : indices) take_one(clock_s, index, {}, roughly);
  if (roughly) return;
  std::vector<std::pair<std::size_t, double>> again;
  for (const auto index : indices) {
    if (!kept(index).unusable.empty()) continue;
    const double px_per_rad = agreed_px_per_rad(index);
    const auto at = std::ranges::find(taken_, index, &Taken::index);
    if (px_per_rad > 0 && (at == taken_.end() || !is_alike(at->px_per_rad, px_per_rad)))
      again.emplace_back(index, px_per_rad);
  }
  for (const auto& [index, px_per_rad] : again) take_in_scale(clock_s, index, px_per_rad);
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

Night::CoarseFit Night::coarse_fit(double clock_s) const {
  constexpr int aerosols = 16, clouds = 8;
  const auto& [aerosol, cloud, ozone] = unknowns_of(unknowns_of(request_));
  CoarseFit fit{night_light(request_.moon.light, unknowns_of(request_), binned_, instants(clock_s),
                            clock_error_s_, FittedAirs::coarse, heartbeat_),
                ComparedNight(binned_, {clock_error_s_, believed_s_ - clock_s, curve_})};
  const auto part = [](const Unknown& unknown, double share) {
    return unknown.from_axis(
        std::lerp(unknown.on_axis(unknown.least), unknown.on_axis(unknown.most), share));
  };
  const double mean_ozone = (ozone.least + ozone.most) / 2;
  for (int i = 0; i <= aerosols; ++i) {
    const double some_aerosol = part(aerosol, static_cast<double>(i) / aerosols);
    const auto at = fit.light.over_cloud(some_aerosol, mean_ozone);
    for (int j = 0; j <= clouds; ++j) {
      const double some_cloud = part(cloud, static_cast<double>(j) / clouds);
      const auto found = fit.compared.goodness(at.under(some_cloud));
      if (found.chi_squared >= fit.goodness.chi_squared) continue;
      fit.goodness = found;
      fit.best = {some_aerosol, some_cloud, mean_ozone};
    }
  }
  return fit;
}

bool Night::leave_out_worst() {
  constexpr std::size_t least = 3;
  constexpr double well = 0.8, stop = std::numbers::ln2, doubtful_stops = 1, any_stops = 3;
  if (taken_.size() < least) return false;
  const auto fit = coarse_fit(clock_s_);
  // by the channel that misfits least: what is misplaced misfits in all
  std::map<std::size_t, double> off;
  for (const auto& misfit : fit.compared.misfits(fit.light.at(fit.best))) {
    const auto [known, first] = off.try_emplace(misfit.photograph, misfit.mean);
    if (std::abs(misfit.mean) < std::abs(known->second)) known->second = misfit.mean;
  }
  const auto worst =
      std::ranges::max_element(off, {}, [](const auto& one) { return std::abs(one.second); });
  if (worst == off.end()) return false;
  const auto place = static_cast<std::ptrdiff_t>(worst->first);
  const auto taken = taken_[worst->first];
  const auto& pose = taken.registration.render_to_photo;
  const auto unlike = std::ranges::count_if(taken_, [&](const Taken& other) {
    return !are_turned_alike(pose, other.registration.render_to_photo);
  });
  const bool doubtful = taken.registration.correlation < well || 2 * unlike > std::ssize(taken_);
  const double stops = worst->second / stop;
  if (std::abs(stops) < (doubtful ? doubtful_stops : any_stops)) return false;
  left_out_[taken.index] = reason_with_shares(
      kept(taken.index).moon,
      fmt::format(
          "light {:+.1f} stops from that of the night's other photographs: a misplaced Moon "
          "(correlation {:.2f}, turned by {:.0f} degrees), or another exposure than the "
          "header's",
          stops, taken.registration.correlation, pose.rotation_rad * 180 / std::numbers::pi));
  taken_.erase(taken_.begin() + place);
  binned_.erase(binned_.begin() + place);
  return true;
}

void Night::leave_out_far() {
  constexpr std::ptrdiff_t least = 3;
  constexpr double far_km = 50;
  std::vector<double> off_km;
  for (std::size_t place = 0; place < taken_.size(); ++place)
    off_km.push_back(off_limb_km(binned_[place].scene, taken_[place].registration));
  const auto is_near = [](double km) { return km <= far_km; };
  if (std::ranges::count_if(off_km, is_near) < least) return;
  for (auto place = std::ssize(taken_); place-- > 0;) {
    const double km = off_km[static_cast<std::size_t>(place)];
    if (is_near(km)) continue;
    const auto index = taken_[static_cast<std::size_t>(place)].index;
    left_out_[index] = reason_with_shares(
        kept(index).moon,
        fmt::format("a misplaced Moon: its limb is {:.0f} km from where its markings say, allowed "
                    "0 to {}",
                    km, far_km));
    taken_.erase(taken_.begin() + place);
    binned_.erase(binned_.begin() + place);
  }
}

void Night::leave_out_misplaced() {
  leave_out_far();
  while (leave_out_worst()) {
  }
}

std::vector<std::size_t> Night::some(std::size_t most) const {
  const auto all = photographs_.size(), count = std::min(most, all);
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < count; ++i)
    indices.push_back(count == 1 ? 0 : i * (all - 1) / (count - 1));
  return indices;
}

std::vector<ClockView> Night::views() {
  std::vector<ClockView> all;
  for (std::size_t place = 0; place < taken_.size(); ++place) {
    const auto& [index, registration, px_per_rad] = taken_[place];
    all.push_back(clock_view(binned_[place].scene, kept(index).moon.photo,
                             registration.render_to_photo, is_curved(*photographs_[index]),
                             photographs_[index]->instant));
  }
  return all;
}

std::array<double, 2> Night::possible_s() const {
  if (!request_.half_hours_free) return {-farthest_clock_s(), farthest_clock_s()};
  constexpr int farthest = 52;  // half hours: zones are 26 hours apart
  const auto contacts =
      eclipse::nearest_eclipse(photographs_.front()->instant, eclipse::ShadowConvention::danjon)
          .contacts;
  std::array<double, 2> range{};
  std::ptrdiff_t most = 0;
  for (int step = -farthest; step <= farthest; ++step) {
    const double clock_s = step * half_hour_s;
    const auto eclipsed = std::ranges::count_if(photographs_, [&](const auto* photograph) {
      const auto moment = almanac::later(photograph->instant, clock_s);
      return almanac::seconds_between(*contacts.P1, moment) > 0 &&
             almanac::seconds_between(moment, *contacts.P4) > 0;
    });
    if (eclipsed > most) most = eclipsed, range[0] = clock_s;
    if (eclipsed == most) range[1] = clock_s;
  }
  if (most == 0)
    throw algebra::Error(
        "no zone and clock explain the photographs' dates: allowed are those of an eclipse");
  return range;
}

double Night::take_anywhere(std::span<const std::size_t> indices,
                            const std::array<double, 2>& range_s) {
  std::vector<double> clocks_s;
  for (double s = std::ceil(range_s[0] / half_hour_s) * half_hour_s; s <= range_s[1];
       s += half_hour_s)
    clocks_s.push_back(s);
  std::ranges::sort(clocks_s, {}, [](double s) { return std::abs(s); });
  double most = 0, best_s = clocks_s.front();
  for (const double clock_s : clocks_s) {
    take(clock_s, indices, true);
    double alike = 0;  // the better, the nearer the shadow is to its place on the photographs
    for (const auto& taken : taken_) alike += taken.registration.correlation;
    if (alike > most) most = alike, best_s = clock_s;
  }
  take(best_s, indices);
  return best_s;
}

void Night::scan_clock() {
  constexpr std::size_t enough = 6;
  constexpr double near_s = 300, about_s = 1200, least_error_s = 60;
  const bool free = request_.half_hours_free;
  const auto nearest_s = [=](double clock_s) {
    return free ? std::round(clock_s / half_hour_s) * half_hour_s : 0;
  };
  const double error_s = std::max(least_error_s, clock_error_s_);
  const auto believed = [&](double clock_s) {
    return std::pow((clock_s - nearest_s(clock_s)) / error_s, 2);
  };
  auto [from_s, to_s] = possible_s();
  const double taken_s = take_anywhere(some(enough), {from_s, to_s});
  auto seen = views();
  if (seen.empty()) return;  // as the photographs' reasons say
  const double margin_s = free ? half_hour_s / 2 : 0;
  auto found = scanned_clock(*groundwork_, seen, from_s - margin_s, to_s + margin_s, believed);
  if (std::abs(found.seconds - taken_s) > near_s) {
    take(found.seconds, some(enough));
    seen = views();
    if (!seen.empty())
      found = scanned_clock(*groundwork_, seen, found.seconds - about_s, found.seconds + about_s,
                            believed);
  }
  believed_s_ = nearest_s(found.seconds);
  clock_s_ = clock_error_s_ > 0 ? found.seconds : believed_s_;
  if (clock_error_s_ > 0 && found.decided)
    clock_error_s_ = std::max(clock_error_s_, std::abs(clock_s_ - believed_s_));
}

void Night::find_clock() {
  constexpr int most_looks = 8;
  constexpr double linear_s = 60;  // of light beside a moment
  for (int look = 0; look < most_looks; ++look) {
    const double further_s = std::clamp(coarse_fit(clock_s_).goodness.clock_s, -300., 300.);
    clock_s_ += further_s;
    if (std::abs(further_s) < linear_s) return;
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

void Night::register_again(const AirFit& fit) {
  constexpr double less_alike = 0.1;
  auto moon = request_.moon;
  moon.light.air = with_unknowns(moon.light.air, fit.unknowns, fit.best);
  const auto groundwork = groundwork_of(moon, way(), request_.response_assumed);
  for (std::size_t place = 0; place < taken_.size(); ++place) {
    auto& [index, registration, px_per_rad] = taken_[place];
    auto& scene = binned_[place].scene;
    const auto in_air = fit_scene(moon, groundwork, request_.view, scene.sky);
    const auto& part = kept(index).moon;
    try {
      const auto again =
          registration_of(in_air, part, agreed_px_per_rad(index) * scene.pixel_rad / part.shrunk);
      if (again.correlation < registration.correlation - less_alike) continue;  // misplaced
      registration = again;
      scene = in_air;
    } catch (const algebra::Error&) {  // it stays as it was registered in the usual air
    }
  }
}

bool Night::refine(const AirFit& fit) {
  const bool again = registered_in_best_air_;
  const bool focused = curved() || (again && is_well_within(fit, light_->range()));
  const bool is_read = again && (!curved() || curves_read_ == most_curves_read);
  if (is_read && focused) return false;
  heartbeat_(0);
  expected_ = light_at(*light_, fit);
  clouded_ = light_->at(clouded_numbers(fit));
  clouded_by_ = cloud_is_a_chance(fit) ? std::log1p(more_cloud) : 0;
  const auto curve = compared_->curve(expected_);
  mixing_ = compared_->mixing(expected_);
  curve_ = curve;
  if (!again) register_again(fit);
  if (!focused) compute_light(heartbeat_, range_about(fit));
  registered_in_best_air_ = true;
  ++curves_read_;
  read_light();
  compare();
  return true;
}

colour::ToneCurve Night::curve(const AirFit& fit) const {
  return compared_->curve(light_at(*light_, fit));
}

std::vector<MeasuredLight> Night::measured(const AirFit& fit) const {
  return compared_->measured(light_at(*light_, fit));
}

std::vector<Misfit> Night::misfits(const AirFit& fit) const {
  auto all = compared_->misfits(light_at(*light_, fit));
  for (auto& misfit : all) misfit.photograph = taken_[misfit.photograph].index;
  return all;
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
                        kept_[taken.index]->clipped_at,
                        {}};
  }
  return all;
}

}  // namespace coppermoon::uses
