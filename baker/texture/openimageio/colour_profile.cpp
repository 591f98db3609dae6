// SPDX-License-Identifier: MIT
#include "texture/openimageio/colour_profile.h"

#include <lcms2.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "algebra/error.h"

namespace coppermoon::texture {
namespace {

using algebra::Error;
using IccProfile = std::unique_ptr<void, decltype(&cmsCloseProfile)>;

constexpr std::array<double, 8> rec709{0.64, 0.33, 0.3, 0.6, 0.15, 0.06, 0.3127, 0.329};

using ToneCurve = std::unique_ptr<cmsToneCurve, decltype(&cmsFreeToneCurve)>;

ToneCurve tone_curve(std::optional<double> power) {
  constexpr int srgb_form = 4;  // ICC's number for the curve (a x + b)^g from d upwards, c x below
  const std::array<double, 5> srgb{2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045};
  return {power ? cmsBuildGamma(nullptr, *power)
                : cmsBuildParametricToneCurve(nullptr, srgb_form, srgb.data()),
          &cmsFreeToneCurve};
}

IccProfile profile_of(const std::array<double, 8>& xy, std::optional<double> power) {
  const cmsCIExyY white_point{xy[6], xy[7], 1};
  const cmsCIExyYTRIPLE primaries{{xy[0], xy[1], 1}, {xy[2], xy[3], 1}, {xy[4], xy[5], 1}};
  const auto curve = tone_curve(power);
  const std::array<cmsToneCurve*, 3> curves{curve.get(), curve.get(), curve.get()};
  IccProfile made(cmsCreateRGBProfile(&white_point, &primaries, curves.data()), &cmsCloseProfile);
  if (!made) throw Error("primaries that no light has");
  return made;
}

std::shared_ptr<void> to_rec709(const IccProfile& from, bool grey) {
  const auto linear = profile_of(rec709, 1);
  std::shared_ptr<void> transform(
      cmsCreateTransform(from.get(), grey ? TYPE_GRAY_FLT : TYPE_RGB_FLT, linear.get(),
                         TYPE_RGB_FLT, INTENT_RELATIVE_COLORIMETRIC,
                         cmsFLAGS_NOCACHE | cmsFLAGS_NOOPTIMIZE),
      [](void* made) {
        if (made) cmsDeleteTransform(made);
      });
  if (!transform) throw Error("a colour profile that gives no light");
  return transform;
}

std::string name_of(const IccProfile& profile) {
  std::array<char, 128> text{};
  cmsGetProfileInfoASCII(profile.get(), cmsInfoDescription, "en", "US", text.data(), text.size());
  return text.data();
}

bool is_srgb(const ColourProfile& profile, std::size_t channels) {
  const auto light = [](float v) {
    return v <= 0.04045F ? v / 12.92F : std::pow((v + 0.055F) / 1.055F, 2.4F);
  };
  std::vector<std::array<float, 3>> tried;
  for (const float v : {0.F, 0.1F, 0.25F, 0.5F, 0.75F, 1.F}) tried.push_back({v, v, v});
  if (channels == 3) tried.insert(tried.end(), {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  for (const auto& coded : tried) {
    std::array<float, 3> found{};
    profile.light(coded.data(), found.data(), 1);
    for (std::size_t k = 0; k < 3; ++k)
      if (std::abs(found[k] - light(coded[k])) > 0.005F) return false;
  }
  return true;
}

}  // namespace

std::optional<ColourProfile> ColourProfile::of_icc(std::string_view bytes, std::size_t channels) {
  const IccProfile profile(
      cmsOpenProfileFromMem(bytes.data(), static_cast<cmsUInt32Number>(bytes.size())),
      &cmsCloseProfile);
  if (!profile) throw Error("a broken colour profile (ICC)");
  const auto space = cmsGetColorSpace(profile.get());
  if (space != (channels == 1 ? cmsSigGrayData : cmsSigRgbData))
    throw Error("the colour profile \"" + name_of(profile) + "\", which is of other channels");
  ColourProfile made(to_rec709(profile, channels == 1));
  return is_srgb(made, channels) ? std::nullopt : std::optional(made);
}

std::optional<ColourProfile> ColourProfile::of_primaries(const std::array<double, 8>& xy,
                                                         std::optional<double> power) {
  const auto alike = [](double a, double b) { return std::abs(a - b) < 0.005; };
  if (std::ranges::equal(xy, rec709, alike)) return std::nullopt;
  return ColourProfile(to_rec709(profile_of(xy, power), false));
}

ColourProfile ColourProfile::adobe_rgb() {
  return ColourProfile(to_rec709(
      profile_of({0.64, 0.33, 0.21, 0.71, 0.15, 0.06, 0.3127, 0.329}, 563. / 256), false));
}

void ColourProfile::light(const float* coded, float* rgb, std::size_t texels) const {
  cmsDoTransform(transform_.get(), coded, rgb, static_cast<cmsUInt32Number>(texels));
}

}  // namespace coppermoon::texture
