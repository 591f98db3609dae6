// SPDX-License-Identifier: MIT
#pragma once

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "algebra/interpolation.h"
#include "algebra/random.h"
#include "colour/camera.h"
#include "colour/camera_spectra.h"
#include "colour/measured_tone_curves.h"
#include "colour/photograph.h"
#include "colour/similarity.h"
#include "colour/srgb.h"
#include "eclipse/contacts.h"
#include "eclipse/shadow_axis.h"
#include "povray_scenes/scene_camera.h"
#include "support/maker_notes.h"
#include "support/program.h"
#include "surface/albedo_map.h"
#include "texture/bake.h"
#include "texture/write_image.h"
#include "uses/fit/fit.h"
#include "uses/light/spectral_bands.h"
#include "uses/picture/pixels.h"
#include "uses/picture/view.h"

namespace coppermoon::end_to_end {

/// Air of the month, changed by factors, and weather along the limb.
struct MonthTruth {
  double stratospheric_factor = 1, cloud_chance = 1, ozone_factor = 1;
  /// Standard deviations of the logarithms of cloud's chance and of aerosol from each 30° of position angle to the next.
  /// The logarithm of the umbra's red light falls by 0.3 of that of the chance: 0.66 makes 20 %, as photographs showed.
  double weather = 0.66, aerosol = 0.3;
};

/// A stranger's camera.
struct StrangersCamera {
  std::string name = "Canon EOS 600D";      ///< in the header
  std::string response = "canon-eos-600d";  ///< filters, of colour::camera_spectra_names
  bool says_shutter = false;  ///< the header has the exact time too (ShutterSpeedValue)
};

/// What a night's photographs are made with, and a fit is not told.
struct NightTruth {
  double dust_per_m = 3e-6, cloud_cover = 0.3, ozone_du = 300;  ///< without a month
  std::optional<MonthTruth> month{};
  std::optional<StrangersCamera> stranger{};
  std::string camera = "Canon EOS 6D";  ///< whose tone curve: measured_tone_curves
  double clock_s = 0;                   ///< to be added to what the camera's clock says
  double exposed = 1;                   ///< factor on all exposures
  /// of each photograph beside what the scene asks for, standard, as cameras set it by themselves
  double white_balance_drift = 0.05;
  bool notes = false;  ///< the header has the white balance, as Canon and Nikon write it
  double toe = 0;      ///< how much darker than by the curve black is shown: a logarithm of levels
  glm::dvec3 lifted{0};     ///< what the camera adds to each channel, over the brightest one
  double matrix_error = 0;  ///< standard, of each mixture of two channels
  double saturation = 1;    ///< of the JPEG's style
  /// of the ground's albedo in each place of 200 km and each channel, standard, from the map that a fit is told
  double map_error = 0.012;
  std::uint64_t seed = 1;
};

/// An eclipse, where it is seen from, and minutes from its greatest phase at which photographs are taken.
struct NightOccasion {
  const char* greatest;
  double latitude_deg, longitude_deg;
  std::vector<double> short_min, long_min;  ///< of sunlit ground; of the umbra
};

/// Photographs of one night as a camera takes them by itself: JPEGs with its own tone curve, brightness and white
/// balance that drift, clipped shadows, lights and colours, a clock that is wrong. The light is planned and computed as for any
/// frame; the fit's own bins and nodes have no part in it.
class MadeNight {
 public:
  MadeNight(const NightOccasion& occasion, const NightTruth& truth)
      : occasion_(occasion), truth_(truth), random_(truth.seed, 7) {
    moon_.albedo_map = "built-in";
    auto& air = moon_.light.air;
    if (truth.month) {
      change_month(air, *truth.month);
    } else {
      air.atmosphere = "undated";
      air.column.dust_extinction_per_m = truth.dust_per_m;
      air.column.cloud_cover = truth.cloud_cover;
      air.column.ozone_du = truth.ozone_du;
    }
    moon_.light.wish = {.tolerance = truth.month ? 0.01 : 0.003};  // regions take long
    view_.observer =
        almanac::Observer{algebra::degrees(occasion.latitude_deg),
                          algebra::degrees(occasion.longitude_deg), algebra::metres(0)};
    view_.reddening = false;
    view_.field_deg = field_deg;
    view_.width = view_.height = side;
    angle_rad_ = 2 * std::numbers::pi * random_.uniform();
    mixture_ = mixture();
    if (truth.stranger) {
      const auto spectra = colour::camera_spectra(truth.stranger->response);
      rec709_from_channels_ = colour::channels_from_xyz(colour::WorkingSpace::linear_rec709) *
                              spectra.xyz_from_balanced;
      by_daylight_ = spectra.daylight.g / spectra.daylight;
    }
    algebra::Random ground(truth.seed, 8);
    for (double& factor : ground_factors_) factor = std::exp(truth.map_error * normal_of(ground));
  }

  /// The request of a fit that knows what a photographer knows.
  uses::FitRequest request(const std::filesystem::path& folder) {
    uses::FitRequest request;
    request.moon.albedo_map = albedo_map(folder);
    if (!truth_.month) request.moon.light.air.atmosphere = "undated";
    request.view.observer = view_.observer;
    request.view.reddening = false;
    request.clock_error_s = 600;
    std::vector<std::pair<double, bool>> all;
    for (const double min : occasion_.short_min) all.emplace_back(min, false);
    for (const double min : occasion_.long_min) all.emplace_back(min, true);
    std::ranges::sort(all);
    std::vector<almanac::SkyState> skies;
    for (const auto& [min, deep] : all) skies.push_back(almanac::sky_at(taken_at(min)));
    std::vector<almanac::SkyState> way;
    for (double min = all.front().first; min < all.back().first + 5; min += 5)
      way.push_back(almanac::sky_at(taken_at(min)));
    const auto light = uses::light_on_the_way(moon_.light, uses::moon_on_its_way(moon_.light, way))
                           .in_channels(uses::moonlight_weights(colour::channel_weights(
                               colour::WorkingSpace::linear_rec709, uses::band_edges_nm(),
                               truth_.stranger ? truth_.stranger->response : "")));
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto file = folder / fmt::format("{:02}.jpg", i);
      const auto told = almanac::later(skies[i].when, -truth_.clock_s);
      photograph(file, skies[i], light, all[i].second, told);
      request.photographs.push_back({.file = file.string(), .instant = told});
    }
    return request;
  }

  /// Geometric mean over the limb of a factor on the month's air, which one factor for all of the limb stands for:
  /// weather adds to the logarithm of light.
  double mean_of(std::optional<double> uses::ColumnChange::*factor) const {
    const auto& air = moon_.light.air;
    double sum = 0;
    for (const auto& region : air.regions) sum += std::log(*(region.column.*factor));
    return air.regions.empty() ? (air.column.*factor).value_or(1)
                               : std::exp(sum / static_cast<double>(air.regions.size()));
  }

 private:
  /// The built-in Moon's, made once.
  static const algebra::Grid<float>& albedo() {
    static const auto map = [] {
      uses::MoonRequest moon;
      moon.albedo_map = "built-in";
      return uses::normal_albedo(moon);
    }();
    return map;
  }

  /// A file of it, for it takes seconds to be made.
  static std::string albedo_map(const std::filesystem::path& folder) {
    const auto file = (folder / "moon.exr").string();
    if (std::filesystem::exists(file)) return file;
    texture::Image image(albedo().columns(), albedo().rows(), {"Y"});
    std::ranges::copy(albedo().values(), image.values.begin());
    texture::write_exr(file, image, {}, {.type = texture::ExrType::floating});
    return file;
  }

  static constexpr std::size_t side = 360;
  static constexpr double field_deg = 0.72;

  almanac::Instant taken_at(double min) const {
    return almanac::later(almanac::instant_from_utc(occasion_.greatest), 60 * min);
  }

  static double normal_of(algebra::Random& random) {
    return std::sqrt(-2 * std::log(1 - random.uniform())) *
           std::cos(2 * std::numbers::pi * random.uniform());
  }

  double normal() { return normal_of(random_); }

  /// Ground's albedo over the map's, by channel, in cells of 200 km.
  std::span<const double, 3> ground_factors(const glm::dvec3& ground) const {
    const auto cell = [](double x) {
      return static_cast<std::size_t>(std::clamp((x + 1) / 2, 0., 1. - 1e-9) * cells_across);
    };
    const auto place =
        (cell(ground.x) * cells_across + cell(ground.y)) * cells_across + cell(ground.z);
    return std::span<const double, 3>(&ground_factors_[3 * place], 3);
  }

  void change_month(uses::Air& air, const MonthTruth& month) {
    constexpr int region_deg = 30;
    auto& column = air.column;
    column.stratospheric_factor = month.stratospheric_factor;
    column.ozone_factor = month.ozone_factor;
    column.cloud_chance = month.cloud_chance;
    for (int from = 0; month.weather > 0 && from < 360; from += region_deg) {
      auto& region = air.regions.emplace_back();
      region.from_position_angle = from;
      region.to_position_angle = from + region_deg;
      region.column.cloud_chance = month.cloud_chance * std::exp(month.weather * normal());
      region.column.stratospheric_factor =
          month.stratospheric_factor * std::exp(month.aerosol * normal());
    }
  }

  /// Mixture of channels by a matrix that is wrong, and by a JPEG's saturation; white stays white.
  glm::dmat3 mixture() {
    glm::dmat3 matrix(1), saturated(0);
    for (int from = 0; from < 3; ++from)
      for (int to = 0; to < 3; ++to) {
        if (from == to) continue;
        const double error = truth_.matrix_error * normal();
        matrix[from][to] += error;
        matrix[to][to] -= error;
      }
    const glm::dvec3 luma(0.2126, 0.7152, 0.0722);
    for (int from = 0; from < 3; ++from)
      for (int to = 0; to < 3; ++to)
        saturated[from][to] =
            (1 - truth_.saturation) * luma[from] + (from == to ? truth_.saturation : 0);
    return saturated * matrix;
  }

  /// The scene [cd/m²] in the channels of the camera, a mean over four places of each pixel.
  colour::Image scene(const almanac::SkyState& sky, const shadow::Lookup& lookup) const {
    const auto channels_from_rec709 = glm::inverse(rec709_from_channels_);
    const auto seen = uses::view_of(view_, sky);
    const auto sight = povray_scenes::sight_of(seen.camera);
    const auto axis = eclipse::shadow_axis(sky);
    const shadow::Lookup whole(shadow::ChannelWeights(1, 1, 1.));
    const auto texture = texture::bake({albedo(), sky, whole}, {"Y"}, 1024, moon_.photometry);
    algebra::Grid<float> map(texture.height, texture.width);
    std::ranges::copy(texture.values, map.values().begin());
    colour::Image image(side, side);
    std::array<double, 3> values{};
    for (std::size_t r = 0; r < side; ++r)
      for (std::size_t c = 0; c < side; ++c)
        for (int part = 0; part < 4; ++part) {
          const auto ground =
              povray_scenes::ground_at(sight, {static_cast<double>(c) + 0.25 + 0.5 * (part % 2),
                                               static_cast<double>(r) + 0.25 + 0.5 * (part / 2)});
          if (!ground) continue;
          lookup.read(eclipse::place_of_ground(axis, sky, *ground), values);
          if (std::max({values[0], values[1], values[2]}) < 1e-20) continue;
          const auto channels = channels_from_rec709 * glm::dvec3(values[0], values[1], values[2]);
          const double bright = surface::sampled(map, almanac::selenographic_point(*ground)) / 4;
          const auto factors = ground_factors(glm::normalize(*ground));
          for (std::size_t k = 0; k < 3; ++k)
            image(r, c)[k] += static_cast<float>(bright * factors[k] *
                                                 std::max(0., channels[static_cast<int>(k)]));
        }
    return image;
  }

  struct Setting {
    double time_s, iso;
  };

  /// A setting, in thirds of stops, that shows the brightest ground, or what is in the umbra. A stranger holds still for
  /// a second at most.
  Setting setting_for(const colour::Image& image, const colour::Camera& camera, bool deep) const {
    const double time_s = time_for(image, camera, deep);
    if (!truth_.stranger) return {std::clamp(time_s, 1e-4, 8.), iso};
    double faster = 0.25;  // ISO 100
    while (time_s / faster > 1 && faster < 16) faster *= 2;
    return {std::min(time_s / faster, 1.), iso * faster};
  }

  double time_for(const colour::Image& image, const colour::Camera& camera, bool deep) const {
    std::vector<double> lit;
    for (const auto& pixel : image.values())
      if (const double most = std::max({pixel[0], pixel[1], pixel[2]}); most > 0)
        lit.push_back(most);
    std::ranges::sort(lit);
    const double light = deep ? 3 * lit[lit.size() / 4] : lit[lit.size() * 98 / 100];
    const double saturation_s =
        colour::saturation_cd_m2(camera, {1, f_number, iso}) / light / truth_.exposed;
    return std::exp2(std::round(3 * std::log2(0.55 * saturation_s)) / 3);
  }

  void photograph(const std::filesystem::path& file, const almanac::SkyState& sky,
                  const shadow::Lookup& lookup, bool deep, const almanac::Instant& told) {
    auto camera = colour::camera_named("400mm");
    camera.seeing_arcsec = 2;
    auto image = scene(sky, lookup);
    const auto setting = setting_for(image, camera, deep);
    const auto [time_s, speed] = setting;
    constexpr double shutter = 0.1;  // 17 % between frames of one setting were seen
    const double pixel_rad = 2 * std::tan(field_deg / 2 * std::numbers::pi / 180) / side;
    // a sensor holds more than white, so that white is white in all channels
    constexpr double headroom = 1.6;
    for (auto& pixel : image.values())
      for (float& value : pixel) value *= static_cast<float>(truth_.exposed / headroom);
    const auto taken =
        colour::photographed(image, colour::WorkingSpace::linear_rec709, camera,
                             {{time_s * std::exp(shutter * normal()), f_number, speed},
                              pixel_rad,
                              2e-4,
                              truth_.seed,
                              frame_++});
    auto shown = uses::image_of(taken.scene_linear);
    const double white = colour::saturation_cd_m2(camera, {time_s, f_number, speed}) / headroom;
    for (float& value : shown.values) value /= static_cast<float>(white);
    const auto gains = automatic_balance(shown);
    develop(shown, gains);
    write_jpeg(file, turned(shown), setting, told);
    if (const auto make = make_of_camera(); truth_.notes && (make == "Canon" || make == "NIKON")) {
      const auto as_shot = gains * by_daylight_;
      support::write_balance(file.string(), make, {as_shot.r, as_shot.g, as_shot.b});
    }
  }

  /// Gains that the camera chooses, relative to those of daylight. From sunlit ground to the umbra, an EOS 550D went from
  /// 2166 of red and 1686 of blue, over 1024, to 1542 and 2260.
  glm::dvec3 automatic_balance(const texture::Image& channels) {
    constexpr double reddest = 1.5;  // logarithm of red over blue
    glm::dvec3 sum(1e-9);
    for (std::size_t i = 0; i < channels.values.size(); ++i)
      sum[static_cast<int>(i % 3)] += std::clamp(channels.values[i], 0.F, 1.F);
    const double umbra = std::clamp(std::log(sum.r / sum.b) / reddest, 0., 1.);
    const double red = truth_.white_balance_drift * normal(),
                 blue = truth_.white_balance_drift * normal();
    return {std::pow(1542. / 2166, umbra) * std::exp(red), 1,
            std::pow(2260. / 1686, umbra) * std::exp(blue)};
  }

  /// From the camera's channels to linear Rec.709, without what no sRGB holds.
  void develop(texture::Image& image, const glm::dvec3& gains) const {
    for (std::size_t i = 0; i < image.values.size(); i += 3) {
      auto* pixel = &image.values[i];
      const auto mixed =
          mixture_ * rec709_from_channels_ * (gains * glm::dvec3(pixel[0], pixel[1], pixel[2]));
      const double brightest = std::max({mixed.r, mixed.g, mixed.b, 0.});
      for (int k = 0; k < 3; ++k)
        pixel[k] = static_cast<float>(std::max(0., mixed[k] + truth_.lifted[k] * brightest));
    }
  }

  std::string name_of_camera() const {
    return truth_.stranger ? truth_.stranger->name : truth_.camera;
  }

  std::string make_of_camera() const {
    const auto name = name_of_camera();
    return name.starts_with("ILCE")  ? "SONY"
           : name.starts_with("X-T") ? "FUJIFILM"
                                     : name.substr(0, name.find(' '));
  }

  texture::Image turned(const texture::Image& image) const {
    texture::Image result(side, side, {"R", "G", "B"});
    const double middle = side / 2., c = std::cos(angle_rad_), s = std::sin(angle_rad_);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto channel = uses::channel_of(image, k);
      for (std::size_t r = 0; r < side; ++r)
        for (std::size_t col = 0; col < side; ++col) {
          const double x = static_cast<double>(col) + 0.5 - middle,
                       y = static_cast<double>(r) + 0.5 - middle;
          result(r, col, k) = static_cast<float>(
              colour::between_pixels(channel, {middle + c * x - s * y, middle + s * x + c * y}));
        }
    }
    return result;
  }

  /// A time in thirds of stops as cameras name it: 1/30 for 1/32.
  static double nominal_s(double time_s) {
    constexpr std::array names{1.,   1.3,  1.6,  2.,   2.5,  3.,   4.,   5.,   6.,   8.,   10.,
                               13.,  15.,  20.,  25.,  30.,  40.,  50.,  60.,  80.,  100., 125.,
                               160., 200., 250., 320., 400., 500., 640., 800., 1000.};
    const auto third = static_cast<std::size_t>(std::lround(-3 * std::log2(time_s)));
    return 1 / names[std::min(third, names.size() - 1)];
  }

  void write_jpeg(const std::filesystem::path& file, const texture::Image& image,
                  const Setting& setting, const almanac::Instant& told) const {
    const auto curve = measured_tone_curves().at(truth_.camera).smooth();
    std::vector<float> shown;
    for (const float value : image.values) {
      const double y = std::clamp(curve(std::clamp(double{value}, 0., 1.)), 0., 1.);
      const double level = colour::srgb_code(y);
      constexpr double toe_ends = 0.1;
      shown.push_back(
          static_cast<float>(level * std::exp(-truth_.toe * std::max(0., 1 - level / toe_ends))));
    }
    OIIO::ImageSpec spec(side, side, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("compression", "jpeg:92");
    spec.attribute("Make", make_of_camera());
    spec.attribute("Model", name_of_camera());
    // OpenImageIO 2.4 writes whole seconds as a fraction over nothing
    const double time_s = truth_.stranger ? nominal_s(setting.time_s) : setting.time_s;
    spec.attribute("ExposureTime", static_cast<float>(time_s * 1.0001));
    if (!truth_.stranger) spec.attribute("FNumber", static_cast<float>(f_number));
    if (truth_.stranger && truth_.stranger->says_shutter)
      spec.attribute("Exif:ShutterSpeedValue", static_cast<float>(-std::log2(setting.time_s)));
    spec.attribute("Exif:PhotographicSensitivity", static_cast<int>(setting.iso));
    spec.attribute("Exif:WhiteBalance", 0);
    auto date = almanac::utc_text(told).substr(0, 19);
    std::ranges::replace(date, '-', ':');
    date[10] = ' ';
    spec.attribute("Exif:DateTimeOriginal", date);
    const auto out = OIIO::ImageOutput::create(file.string());
    out->open(file.string(), spec);
    out->write_image(OIIO::TypeDesc::FLOAT, shown.data());
    out->close();
  }

  static constexpr double f_number = 5.6, iso = 400;

  NightOccasion occasion_;
  NightTruth truth_;
  algebra::Random random_;
  uses::MoonRequest moon_;
  uses::ViewRequest view_;
  double angle_rad_ = 0;
  glm::dmat3 mixture_{1}, rec709_from_channels_{1};
  glm::dvec3 by_daylight_{2.115, 1, 1.646};        ///< gains by which daylight is white
  static constexpr std::size_t cells_across = 17;  ///< of the Moon's diameter
  std::vector<double> ground_factors_ =
      std::vector<double>(3 * cells_across * cells_across * cells_across);
  std::uint64_t frame_ = 0;
};

/// Eclipses with photographs of ingress and egress, sunlit ground and umbra.
inline std::vector<NightOccasion> night_occasions() {
  const std::vector<double> sunlit{-95, -80, 75, 95}, umbra{-80, -30, 0, 30, 85};
  return {{"2018-07-27T20:21:44Z", 10, 45, {-100, -80, 75, 100}, {-85, -40, 0, 40, 85}},
          {"2008-02-21T03:26:03Z", 42.86, -73.77, sunlit, {-75, -15, 0, 15, 80}},
          {"2015-09-28T02:47:07Z", 30, -40, sunlit, umbra},
          {"2010-12-21T08:16:57Z", 40, -100, sunlit, umbra},
          {"2000-07-16T13:55:35Z", -20, 150, {-100, -80, 75, 100}, {-85, -40, 0, 40, 85}}};
}

/// What a camera does to dark levels and colours, and whether it writes its white balance down, at random.
inline void draw_development(NightTruth& truth, algebra::Random& random) {
  constexpr double of_toe = 0.25, most_lifted = 0.02;
  truth.notes = random.uniform() < 0.5;
  const double distance = std::sqrt(-2 * std::log(1 - random.uniform()));
  truth.toe =
      of_toe * std::clamp(distance * std::cos(2 * std::numbers::pi * random.uniform()), -2., 2.);
  for (int k = 0; k < 3; ++k) truth.lifted[k] = most_lifted * random.uniform();
}

/// Air, camera and clock of a night of nine photographs, at random.
inline NightTruth night_truth(std::uint64_t night) {
  algebra::Random random(1504, night);
  const auto between = [&](double from, double to) {
    return from + (to - from) * random.uniform();
  };
  const auto normal = [&] {
    return std::sqrt(-2 * std::log(1 - random.uniform())) *
           std::cos(2 * std::numbers::pi * random.uniform());
  };
  NightTruth truth;
  truth.dust_per_m = 1.5e-6 * std::pow(1e-5 / 1.5e-6, random.uniform());
  truth.cloud_cover = between(0, 0.9);
  truth.ozone_du = between(200, 450);
  static const auto cameras = measured_tone_curves();
  auto camera = cameras.begin();
  std::advance(camera, night / 5 % 5);
  truth.camera = camera->first;
  truth.clock_s = 240 * normal();
  truth.exposed = std::exp(0.3 * normal());
  truth.matrix_error = 0.03;
  truth.saturation = 1 + 0.2 * std::clamp(normal(), -2., 2.);
  truth.seed = night;
  draw_development(truth, random);
  return truth;
}

/// Eclipses with eighteen photographs from the first bite to totality.
inline std::vector<NightOccasion> strangers_occasions() {
  auto all = night_occasions();
  for (auto& occasion : all) {
    const auto eclipse = eclipse::nearest_eclipse(almanac::instant_from_utc(occasion.greatest),
                                                  eclipse::ShadowConvention::danjon);
    const auto minutes = [&](const almanac::Instant& contact) {
      return -almanac::seconds_between(contact, almanac::instant_from_utc(occasion.greatest)) / 60;
    };
    const double u1 = minutes(*eclipse.contacts.U1), u2 = minutes(*eclipse.contacts.U2);
    occasion.short_min.clear();
    occasion.long_min.clear();
    for (const double share : {0.06, 0.18, 0.3, 0.42, 0.54, 0.66, 0.76, 0.86})
      occasion.short_min.push_back(u1 + share * (u2 - u1));
    for (const double share : {0.5, 0.62, 0.74, 0.88})
      occasion.long_min.push_back(u1 + share * (u2 - u1));
    for (const double share : {0.97, 0.8, 0.6, 0.4, 0.2, 0.})
      occasion.long_min.push_back(share * u2);
  }
  return all;
}

/// Name that a camera of colour::camera_spectra_names gives itself in headers: "Canon EOS 600D".
inline std::string named_by_its_maker(const std::string& response) {
  static const std::map<std::string, std::string> names{
      {"canon-eos-5d-mark-ii", "Canon EOS 5D Mark II"},
      {"canon-eos-5d-mark-iii", "Canon EOS 5D Mark III"},
      {"canon-eos-600d", "Canon EOS 600D"},
      {"canon-eos-200d", "Canon EOS 200D"},
      {"canon-eos-r6", "Canon EOS R6"},
      {"nikon-d5100", "NIKON D5100"},
      {"nikon-d5300", "NIKON D5300"},
      {"nikon-d810", "NIKON D810"},
      {"nikon-d850", "NIKON D850"},
      {"sony-ilce-7m3", "ILCE-7M3"},
      {"sony-ilce-7sm2", "ILCE-7SM2"},
      {"fujifilm-x-t3", "X-T3"}};
  return names.at(response);
}

/// What a photographer says of a camera's clock.
enum class ZoneGiven { none, right, an_hour_wrong };

/// A stranger's night: camera and air at random.
struct StrangersNight {
  NightTruth truth;
  NightOccasion occasion;
  ZoneGiven zone;
  double zone_error_s;  ///< of the clock that --zone makes of the header's

  /// Words that tell `fit` what the photographer says.
  Words told() const {
    Words words{"--instants",  "from-header",
                "--at",        fmt::format("{},{}", occasion.latitude_deg, occasion.longitude_deg),
                "--reddening", "off"};
    if (zone != ZoneGiven::none)
      words += words_of("--zone {}", zone == ZoneGiven::right ? "+02:00" : "+03:00");
    return words;
  }
};

inline StrangersNight strangers_night(std::uint64_t night) {
  algebra::Random random(20150928, night);
  const auto between = [&](double from, double to) {
    return from + (to - from) * random.uniform();
  };
  const auto in_decades = [&](double from, double to) {
    return from * std::pow(to / from, random.uniform());
  };
  const auto one_of = [&](const auto& all) {
    auto place = all.begin();
    std::advance(
        place, static_cast<std::ptrdiff_t>(random.uniform() * static_cast<double>(std::size(all))));
    return *place;
  };
  constexpr double zone_s = 2 * 3600, farthest_s = 40 * 60;
  NightTruth truth;
  truth.month = MonthTruth{in_decades(0.3, 5), in_decades(0.4, 2), between(0.7, 1.3)};
  static const auto curves = measured_tone_curves();
  truth.camera = one_of(curves).first;
  StrangersCamera camera;
  camera.response = one_of(colour::camera_spectra_names());
  camera.name = random.uniform() < 0.5 ? named_by_its_maker(camera.response) : "Pentax K-5";
  truth.matrix_error = 0.03;
  truth.saturation = one_of(std::array{0.9, 1., 1.2});
  camera.says_shutter = random.uniform() < 0.5;
  truth.stranger = camera;
  const double error_s = between(-farthest_s, farthest_s);
  truth.clock_s = error_s - zone_s;
  truth.exposed = in_decades(0.5, 2);
  truth.seed = 1000 + night;
  const auto zone = one_of(std::array{ZoneGiven::none, ZoneGiven::right, ZoneGiven::an_hour_wrong});
  draw_development(truth, random);
  if (truth.notes && truth.stranger->name.starts_with("Pentax"))
    truth.stranger->name = "NIKON D3300";  // whose notes are read, and whose filters are not known
  const auto occasions = strangers_occasions();
  return {truth, occasions[night % occasions.size()], zone,
          error_s + (zone == ZoneGiven::an_hour_wrong ? 3600 : 0)};
}

}  // namespace coppermoon::end_to_end
