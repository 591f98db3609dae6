// SPDX-License-Identifier: MIT
#include "texture/bake.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <numbers>
#include <optional>

#include "texture/globe.h"
#include "texture/resize.h"

namespace coppermoon::texture {
namespace {

constexpr std::size_t texels_at_once = 256;

/// Sine of the angle below a texel's horizon beyond which the Earth's centre is so low that no place on Earth sees the
/// texel. It allows for the Earth's radius (up to 0.0181 of its distance), refraction and neighbouring texels.
double sine_of_the_unseen(std::size_t rows) {
  return 0.04 + 1.5 * std::numbers::pi / static_cast<double>(rows);
}

struct Scratch {
  explicit Scratch(std::size_t channels) : numbers((4 + channels) * texels_at_once) {}
  LitTexels lit(std::size_t count) {
    const auto part = [&](std::size_t k) {
      return std::span(numbers).subspan(k * texels_at_once, count);
    };
    return {part(0), part(1), part(2), part(3)};
  }
  std::span<double> values(std::size_t count) {
    return std::span(numbers).subspan(4 * texels_at_once, count);
  }

  std::vector<double> numbers;
  std::vector<float> albedo{}, colour{}, surge{};
};

/// Data and settings shared by all rows of a texture while it is baked.
struct Baking {
  Globe globe;
  const shadow::Lookup& light;
  ResizedRows albedo;
  std::optional<ResizedRows> colour, surge;  // absent if the ground is the same everywhere
  TexelQuantity quantity;
  std::vector<double> sunlit;
  algebra::Progress progress;
  std::atomic<std::size_t> done = 0;

  std::size_t channels() const { return colour ? light.channels() / 2 : light.channels(); }

  /// Writes one texel's channels, given the light at its position and the share of this light that the ground reflects.
  void write(double reflected, std::span<const double> there, std::span<float> texel) const {
    const std::size_t count = texel.size();
    if (quantity == TexelQuantity::luminance)
      for (std::size_t c = 0; c < count; ++c)
        texel[c] = static_cast<float>(reflected * there[c] + 0.);  // adding 0. turns -0 into 0
    else if (quantity == TexelQuantity::irradiance)
      for (std::size_t c = 0; c < count; ++c)
        // FAULT irradiance without the Sun's distance: globe.inverse_square * there => there
        texel[c] = static_cast<float>(reflected > 0 ? globe.inverse_square * there[c] : 0);
    else
      for (std::size_t c = 0; c < count; ++c)
        // FAULT reflectance with the Sun's distance: / globe.inverse_square => / 1
        texel[c] = static_cast<float>(reflected / globe.inverse_square * there[c] + 0.);
  }

  /// Interpolates between the light on the reddest and the bluest ground, by the colour of the texel's ground.
  void mix(std::span<double> there, double bluer) const {
    const std::size_t count = channels();
    const double share = 0.5 + bluer / (2 * surface::strongest_colour);
    for (std::size_t c = 0; c < count; ++c) there[c] += share * (there[count + c] - there[c]);
    if (!sunlit.empty())
      for (std::size_t c = 0; c < count; ++c)
        there[c] /= sunlit[c] + share * (sunlit[count + c] - sunlit[c]);
  }

  void make_own(std::span<double> there, std::span<const float> bluer, std::size_t texel) const {
    if (!bluer.empty())
      mix(there, bluer[texel]);
    else if (!sunlit.empty())
      for (std::size_t c = 0; c < there.size(); ++c) there[c] /= sunlit[c];
  }

  /// Albedo, colour and opposition surge of the ground for consecutive texels in a row.
  struct Texels {
    std::span<const float> albedo, colour, surge;
    Texels part(std::size_t first, std::size_t count) const {
      const auto of = [&](std::span<const float> all) {
        return all.empty() ? all : all.subspan(first, count);
      };
      return {of(albedo), of(colour), of(surge)};
    }
  };

  void light_some(std::size_t row, std::size_t column, const Texels& ground,
                  std::span<float> texels, Scratch& scratch) const {
    const std::size_t count = ground.albedo.size(), looked_up = light.channels(), each = channels();
    const auto lit = scratch.lit(count);
    if (!light_texels(globe, row, column, ground.albedo, ground.surge, lit)) {
      std::ranges::fill(texels, 0.F);
      return;
    }
    const auto values = scratch.values(looked_up * count);
    light.read({lit.east_m, lit.north_m, lit.depth_m}, values);
    for (std::size_t i = 0; i < count; ++i) {
      const auto there = values.subspan(i * looked_up, looked_up);
      make_own(there, ground.colour, i);
      write(lit.reflected[i], there.first(each), texels.subspan(i * each, each));
    }
  }

  void light_row(std::size_t row, std::span<float> texels) {
    Scratch scratch(light.channels());
    Texels ground{albedo.row(row, scratch.albedo), {}, {}};
    if (colour) ground.colour = colour->row(row, scratch.colour);
    if (surge) ground.surge = surge->row(row, scratch.surge);
    if (quantity == TexelQuantity::irradiance) {
      scratch.albedo.assign(ground.albedo.size(), 1);
      ground.albedo = scratch.albedo;
    }
    const std::size_t length = ground.albedo.size();
    for (std::size_t c = 0; c < length; c += texels_at_once) {
      const std::size_t count = std::min(texels_at_once, length - c);
      light_some(row, c, ground.part(c, count), texels.subspan(c * channels(), count * channels()),
                 scratch);
    }
    if (progress) progress(static_cast<double>(++done) / static_cast<double>(globe.rows));
  }
};

}  // namespace

Rows lit_rows(const LitSurface& moon, std::size_t rows, const Lighting& lighting,
              const algebra::Progress& progress) {
  const ResizedRows albedo(moon.normal_albedo, rows);
  const double unseen = lighting.extent == Extent::seen_from_earth
                            ? sine_of_the_unseen(rows)
                            : std::numeric_limits<double>::infinity();
  std::optional<ResizedRows> colour, surge;
  if (moon.ground != nullptr) {
    colour.emplace(moon.ground->colour, rows);
    surge.emplace(moon.ground->surge, rows);
  }
  const std::shared_ptr<Baking> baking(
      new Baking{Globe(moon.sky, rows, lighting.photometry, unseen), moon.light, albedo, colour,
                 surge, lighting.quantity, lighting.sunlit, progress});
  return [baking](std::size_t first_row, std::span<float> values) {
    const std::size_t length = 2 * baking->globe.rows * baking->channels();
    tbb::parallel_for(std::size_t{0}, values.size() / length, [&](std::size_t r) {
      baking->light_row(first_row + r, values.subspan(r * length, length));
    });
  };
}

Rows albedo_rows(const algebra::Grid<float>& normal_albedo, std::size_t rows) {
  return
      [albedo = ResizedRows(normal_albedo, rows)](std::size_t first_row, std::span<float> values) {
        const std::size_t length = 2 * albedo.rows();
        tbb::parallel_for(std::size_t{0}, values.size() / length, [&](std::size_t r) {
          std::vector<float> buffer;
          std::ranges::copy(albedo.row(first_row + r, buffer),
                            values.begin() + static_cast<std::ptrdiff_t>(r * length));
        });
      };
}

Image bake(const LitSurface& moon, std::vector<std::string> channels, std::size_t rows,
           surface::Photometry photometry, const algebra::Progress& progress) {
  const auto fill = lit_rows(moon, rows, {photometry}, progress);
  Image texture(2 * rows, rows, std::move(channels));
  fill(0, texture.values);
  return texture;
}

}  // namespace coppermoon::texture
