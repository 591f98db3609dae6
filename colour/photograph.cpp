// SPDX-License-Identifier: MIT
#include "colour/photograph.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <numbers>
#include <random>

#include "algebra/error.h"
#include "algebra/random.h"
#include "colour/glow.h"
#include "colour/point_spread.h"

namespace coppermoon::colour {
namespace {

using std::numbers::pi;

constexpr double arcsec_rad = pi / 180 / 3600;

/// Mean wavelengths of red, green and blue light [nm], for the diffraction in each channel.
constexpr std::array channels_nm{600., 545., 455.};

/// Adapts algebra::Random so that the standard library's distributions can draw from it.
struct Bits {
  using result_type = std::uint64_t;
  algebra::Random random;

  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return (std::uint64_t{1} << 53) - 1; }
  result_type operator()() { return static_cast<result_type>(random.uniform() * 0x1p53); }
};

void require_finite(const Image& scene) {
  for (std::size_t r = 0; r < scene.rows(); ++r)
    for (std::size_t c = 0; c < scene.columns(); ++c)
      for (const float value : scene(r, c))
        if (!std::isfinite(value))
          throw algebra::Error(
              fmt::format("pixel {}, {} [cd/m2] = {}, allowed finite", c, r, value));
}

/// Blurs a picture by glow, diffraction and seeing.
Image spread(const Image& scene_linear, const Camera& camera, double pixel_rad) {
  auto scene = with_glow(scene_linear, camera.glow, pixel_rad);
  if (!camera.diffraction && camera.seeing_arcsec == 0) return scene;
  Image result(scene.rows(), scene.columns());
  for (std::size_t k = 0; k < 3; ++k) {
    algebra::Grid<double> channel(scene.rows(), scene.columns());
    for (std::size_t i = 0; i < scene.values().size(); ++i)
      channel.values()[i] = scene.values()[i][k];
    channel = blurred(channel,
                      {{camera.optics.aperture_mm * 1e-3, camera.optics.obstruction},
                       camera.diffraction ? channels_nm[k] : 0,
                       camera.seeing_arcsec * arcsec_rad},
                      pixel_rad);
    for (std::size_t i = 0; i < scene.values().size(); ++i)
      result.values()[i][k] = static_cast<float>(channel.values()[i]);
  }
  return result;
}

/// A sensor at given settings. It converts a channel's white-balanced luminance to a raw number, and back.
class Readout {
 public:
  Readout(const Camera& camera, const Shot& shot)
      : camera_(camera),
        gain_(gain_at(camera, shot.exposure.iso)),
        electrons_(electrons_per_cd_m2(camera, shot.exposure)),
        top_(std::exp2(camera.sensor.bits) - 1) {
    const double sensor_rad = camera.sensor.pixel_um * 1e-3 / camera.optics.focal_length_mm;
    pixels_ = shot.pixel_rad * shot.pixel_rad / (sensor_rad * sensor_rad);
  }

  /// Raw number of a pixel in the picture: the mean over those pixels of the sensor that it covers.
  std::uint16_t raw(double luminance, double sensitivity, Bits& bits) const {
    const auto& sensor = camera_.sensor;
    const double well = pixels_ * sensor.full_well_e;
    const double mean = std::clamp(pixels_ * electrons_ * sensitivity * luminance, 0., 2 * well);
    double electrons = mean, added = 0;
    if (camera_.noise) {
      if (mean > 0) electrons = set_free(mean, bits);
      added = normal(bits) *
              std::hypot(gain_.dn_per_electron * sensor.read_noise_e, sensor.converter_noise_dn) /
              std::sqrt(pixels_);
    }
    const double signal = gain_.dn_per_electron * std::min(electrons, well) / pixels_;
    return static_cast<std::uint16_t>(
        std::clamp(std::round(sensor.black_level_dn + signal + added), 0., top_));
  }

  /// Raw number converted to a share of saturation and white-balanced by the channel's sensitivity; at most 1 (white).
  double developed(std::uint16_t raw, double sensitivity) const {
    return std::min(1., (raw - camera_.sensor.black_level_dn) / (gain_.white_dn * sensitivity));
  }

  double saturation_cd_m2() const { return gain_.white_dn / (gain_.dn_per_electron * electrons_); }

 private:
  static double normal(Bits& bits) { return std::normal_distribution<double>()(bits); }

  static double set_free(double mean, Bits& bits) {
    constexpr double many = 1e8;  // above this, the Poisson distribution is practically normal
    if (mean > many) return std::max(0., mean + std::sqrt(mean) * normal(bits));
    return static_cast<double>(std::poisson_distribution<std::int64_t>(mean)(bits));
  }

  const Camera& camera_;
  Gain gain_;
  double electrons_, top_, pixels_ = 1;
};

/// Matrices from a working space to a sensor's channels, and back.
struct Colours {
  glm::dmat3 to_sensor, from_sensor;
  glm::dvec3 sensitivity;
};

Colours colours_of(const Camera& camera, WorkingSpace space) {
  const auto response = response_named(camera.sensor.response);
  const auto working = channels_from_xyz(space);
  const auto to_sensor = response.from_xyz * glm::inverse(working);
  if (camera.sensor.response != "luminance")
    return {to_sensor, glm::inverse(to_sensor), response.sensitivity};
  // A monochrome sensor gives grey, the mean of three equal channels.
  const auto grey = white(space) / 3.;
  return {to_sensor, {grey, grey, grey}, response.sensitivity};
}

/// Raw pixel of a monochrome sensor, whose only channel is stored three times.
RawPixel as_one(const RawPixel& raw) { return {raw[1], raw[1], raw[1]}; }

}  // namespace

Photograph photographed(const Image& scene_linear, WorkingSpace space, const Camera& camera,
                        const Shot& shot) {
  require_finite(scene_linear);
  algebra::require_within("pixel [rad]", shot.pixel_rad, 1e-12, 1);
  algebra::require_within("sky [cd/m2]", shot.sky_cd_m2, 0, 1e6);
  const Readout readout(camera, shot);
  const auto seen = spread(scene_linear, camera, shot.pixel_rad);
  const auto colours = colours_of(camera, space);
  const bool grey = camera.sensor.response == "luminance";
  Photograph result{
      Image(seen.rows(), seen.columns()), algebra::Grid<float>(seen.rows(), seen.columns()),
      algebra::Grid<RawPixel>(seen.rows(), seen.columns()), readout.saturation_cd_m2()};
  tbb::parallel_for(std::size_t{0}, seen.rows(), [&](std::size_t r) {
    for (std::size_t c = 0; c < seen.columns(); ++c) {
      Bits bits{{shot.seed, (shot.frame << 36) + r * seen.columns() + c}};
      const auto& [red, green, blue] = seen(r, c);
      const glm::dvec3 channels = colours.to_sensor * glm::dvec3(red, green, blue) + shot.sky_cd_m2;
      auto& raw = result.raw(r, c);
      for (int k = 0; k < 3; ++k)
        raw[static_cast<std::size_t>(k)] = readout.raw(channels[k], colours.sensitivity[k], bits);
      if (grey) raw = as_one(raw);
      glm::dvec3 balanced;
      for (int k = 0; k < 3; ++k)
        balanced[k] = readout.developed(raw[static_cast<std::size_t>(k)], colours.sensitivity[k]);
      constexpr double sound = 0.9;  // share of saturation, low enough that noise does not clip
      result.valid(r, c) = std::max({balanced.r, balanced.g, balanced.b}) < sound ? 1.F : 0.F;
      const glm::dvec3 scene = result.saturation_cd_m2 * (colours.from_sensor * balanced);
      for (int k = 0; k < 3; ++k)
        result.scene_linear(r, c)[static_cast<std::size_t>(k)] = static_cast<float>(scene[k]);
    }
  });
  return result;
}

}  // namespace coppermoon::colour
