// SPDX-License-Identifier: MIT
#include "uses/fit/placing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coppermoon::uses {
namespace {

/// Correlation at and above which the Moon counts as recognised.
constexpr double well = 0.8;

/// Whether two image scales are close enough to come from the same lens.
bool is_alike(double one, double other) {
  constexpr double alike = 0.02;
  return std::abs(one / other - 1) < alike;
}

/// Factor that converts a registration's scale to the scale of the whole picture [pixels/rad].
double px_per_scale(const Reading& reading, const FitScene& scene) {
  return reading.moon.shrunk / scene.pixel_rad;
}

/// Registers one photograph with the scene at its corrected time.
///
/// Given  px_per_rad  scale of the whole picture, if known
Placed placed_one(const Stage& stage, const Reading& reading, std::size_t index, double clock_s,
                  std::optional<double> px_per_rad, Registering how) {
  if (!reading.left_out.empty()) return {reading.left_out};
  if (stage.alive) stage.alive(0);
  const auto& photograph = stage.request.photographs[index];
  try {
    auto scene = fit_scene(stage.request.moon, stage.groundwork, stage.request.view,
                           almanac::sky_at(almanac::later(photograph.instant, clock_s)));
    const double scale = px_per_scale(reading, scene);
    if (px_per_rad) *px_per_rad /= scale;
    if (how == Registering::of_clipped) scene.glow = glow_of(scene);
    const auto registration = registration_of(scene, reading.moon, px_per_rad, how);
    return {.scene = std::make_shared<const FitScene>(std::move(scene)),
            .registration = registration,
            .px_per_rad = registration.render_to_photo.scale * scale};
  } catch (const algebra::Error& error) {
    return {reason_with_shares(reading.moon, reason_without_name(photograph.file, error))};
  }
}

/// Scale with the greatest sum of correlations among photographs of the same size; 0 if none was registered.
double agreed_px_per_rad(std::span<const Reading> readings, std::span<const Placed> all,
                         std::size_t index) {
  const auto counts = [&](std::size_t i) {
    return all[i].left_out.empty() && readings[i].extent == readings[index].extent;
  };
  double most = 0, agreed = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!counts(i)) continue;
    double sum = 0, scales = 0;
    for (std::size_t j = 0; j < all.size(); ++j)
      if (counts(j) && is_alike(all[j].px_per_rad, all[i].px_per_rad)) {
        sum += all[j].registration.correlation;
        scales += all[j].registration.correlation * all[j].px_per_rad;
      }
    if (sum > most) most = sum, agreed = scales / sum;
  }
  return agreed;
}

/// Whether another photograph was placed at the same scale. If none was, the scale comes only from the photograph's
/// own limb, which glow enlarges.
bool shares_scale(std::span<const Placed> all, std::size_t index) {
  std::size_t alike = 0;
  for (const auto& one : all)
    alike += one.left_out.empty() && is_alike(one.px_per_rad, all[index].px_per_rad);
  return alike > 1;
}

/// Indices of the registered photographs. Those registered at the scale of other photographs come last.
std::vector<std::size_t> order_of(std::span<const Placed> all) {
  std::vector<std::size_t> order;
  for (const bool late : {false, true})
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].left_out.empty() && all[i].in_others_scale == late) order.push_back(i);
  return order;
}

/// Accepts a photograph that was registered again at the scale of the others, unless its correlation is now too low.
Placed in_scale(Placed found, const Placed& before, const Reading& reading) {
  constexpr double as_well = 0.9;
  const double alike = before.left_out.empty() ? before.registration.correlation : 0,
               now = found.left_out.empty() ? found.registration.correlation : 0;
  found.in_others_scale = true;
  if (now >= std::max(well, as_well * alike)) return found;
  if (alike >= well)
    return {reason_with_shares(reading.moon,
                               "a Moon that looks of another size than on the night's other "
                               "photographs: by a zoom, or by the glow of a clipped limb")};
  if (now > 0)
    return {reason_with_shares(
        reading.moon,
        fmt::format(
            "correlation of photograph and Moon in the others' scale = {:.2f}, allowed {} to 1",
            now, well))};
  return before.left_out.empty() ? found : before;
}

}  // namespace

std::vector<Placed> placed(const Stage& stage, std::span<const Reading> readings, double clock_s,
                           std::span<const std::size_t> which, Registering how) {
  std::vector<Placed> first(readings.size(), Placed{"not asked for"});
  for (const auto i : which) first[i] = placed_one(stage, readings[i], i, clock_s, {}, how);
  if (how == Registering::rough) return first;
  auto all = first;
  for (const auto i : which) {
    if (!readings[i].left_out.empty()) continue;
    const double agreed = agreed_px_per_rad(readings, first, i);
    if (agreed > 0 && !(first[i].left_out.empty() && is_alike(first[i].px_per_rad, agreed)))
      all[i] =
          in_scale(placed_one(stage, readings[i], i, clock_s, agreed, how), first[i], readings[i]);
  }
  return all;
}

std::vector<Placed> placed_again(const Stage& stage, std::span<const Reading> readings,
                                 std::vector<Placed> all) {
  constexpr double less_alike = 0.1, most_degrees = 5, sure = 0.998;
  for (const auto i : order_of(all)) {
    all[i].in_its_air = shares_scale(all, i) || all[i].registration.correlation >= sure;
    auto scene =
        fit_scene(stage.request.moon, stage.groundwork, stage.request.view, all[i].scene->sky);
    scene.glow = glow_of(scene);
    try {
      const auto again =
          registration_of(scene, readings[i].moon,
                          agreed_px_per_rad(readings, all, i) / px_per_scale(readings[i], scene));
      const auto& before = all[i].registration;
      if (again.correlation < before.correlation - less_alike ||
          !are_turned_alike(again.render_to_photo, before.render_to_photo, most_degrees))
        continue;  // now worse, or rotated because the computed shadow is wrong
      all[i].registration = again;
      all[i].scene = std::make_shared<const FitScene>(std::move(scene));
    } catch (const algebra::Error&) {  // keep the registration with the assumed air
    }
  }
  return all;
}

void leave_out_far(std::span<const Reading> readings, std::span<Placed> placed) {
  constexpr std::ptrdiff_t least = 3;
  constexpr double far_km = 50;
  const auto off_km = [](const Placed& one) { return off_limb_km(*one.scene, one.registration); };
  const auto is_near = [&](const Placed& one) {
    return one.left_out.empty() && off_km(one) <= far_km;
  };
  if (std::ranges::count_if(placed, is_near) < least) return;
  for (std::size_t i = 0; i < placed.size(); ++i)
    if (placed[i].left_out.empty() && !is_near(placed[i]))
      placed[i] = {reason_with_shares(
          readings[i].moon, fmt::format("a misplaced Moon: its limb is {:.0f} km from where its "
                                        "markings say, allowed 0 to {}",
                                        off_km(placed[i]), far_km))};
}

std::vector<Binned> binned(std::span<const Reading> readings, std::span<const Placed> placed,
                           const colour::ToneCurve& curve) {
  std::vector<Binned> all;
  for (const auto i : order_of(placed)) {
    const auto& [left_out, scene, registration, px_per_rad, in_others_scale, in_its_air] =
        placed[i];
    all.push_back({i, readings[i].colours, scene,
                   binned(*scene, readings[i].moon, registration.render_to_photo,
                          readings[i].curved ? std::optional(curve) : std::nullopt),
                   readings[i].errors});
    all.back().errors.place_error_km = place_error_km(*scene, registration, in_its_air);
  }
  return all;
}

bool are_turned_alike(const colour::Similarity& one, const colour::Similarity& other,
                      double within_degrees) {
  return one.mirrored == other.mirrored && std::cos(one.rotation_rad - other.rotation_rad) >
                                               std::cos(within_degrees * std::numbers::pi / 180);
}

}  // namespace coppermoon::uses
