// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "algebra/error.h"
#include "algebra/number.h"
#include "colour/bracket.h"
#include "colour/exposure.h"
#include "texture/read_image.h"
#include "texture/write_image.h"
#include "verbs/moon_options.h"
#include "verbs/one_line.h"
#include "verbs/one_scene.h"
#include "verbs/photo_file.h"
#include "verbs/pixels.h"
#include "verbs/recipe.h"
#include "verbs/verbs.h"

namespace coppermoon::verbs {
namespace {

struct Options {
  std::vector<std::string> photographs;
  std::string output;
  bool json = false;
};

double number_of(const std::string& file, const char* attribute) {
  const double number =
      algebra::number_in(texture::read_attribute(file, attribute).value_or("")).value_or(0);
  if (!(number > 0))
    throw algebra::Error(fmt::format(
        "{}: its header has no {}, allowed are photographs of --photograph", file, attribute));
  return number;
}

void require_sound(const std::string& file, const texture::Image& image) {
  for (std::size_t i = 0; i < image.values.size(); ++i) {
    const float value = image.values[i];
    const auto channel = i % image.channels.size();
    const bool valid = channel == 3;
    if (valid ? value >= 0 && value <= 1 : std::isfinite(value)) continue;
    const auto pixel = i / image.channels.size();
    throw algebra::Error(fmt::format(
        "{}: {} at row {}, column {} = {:g}, allowed {}", file, image.channels[channel],
        pixel / image.width, pixel % image.width, value, valid ? "0 to 1" : "what is finite"));
  }
}

colour::Bracketed bracketed(const std::string& file) {
  const auto image = texture::read_channels(file, {"R", "G", "B", "valid"});
  require_sound(file, image);
  colour::Bracketed one{pixels_of(image), channel_of(image, 3), 0};
  const double f_number = number_of(file, "aperture"), time_s = number_of(file, "expTime");
  colour::exposure_scale({time_s, f_number});  // their ranges
  one.light = time_s / (f_number * f_number);
  return one;
}

double share_valid(const colour::Bracketed& photograph) {
  double sum = 0;
  for (const float valid : photograph.valid.values()) sum += valid;
  return sum / static_cast<double>(photograph.valid.values().size());
}

void run(const Options& options) {
  require_place_for(options.output);
  std::vector<colour::Bracketed> photographs;
  for (const auto& file : options.photographs) {
    require_one_scene(options.photographs.front(), file);
    photographs.push_back(bracketed(file));
  }
  const auto merged = colour::merged(photographs);
  texture::write_exr(options.output, image_of(merged.scene_linear, merged.valid),
                     scene_attributes(options.photographs.front()),
                     {.type = texture::ExrType::floating, .allow_negative = true});
  const double valid = share_valid(merged);
  if (options.json)
    fmt::print("{}\n", nlohmann::ordered_json{{"file", options.output},
                                              {"photographs", photographs.size()},
                                              {"share_valid", valid}}
                           .dump(2));
  else
    fmt::print("{}: {} photographs, {:.1f} % of the pixels within their range\n",
               one_line(options.output), photographs.size(), 100 * valid);
}

}  // namespace

void add_merge(CLI::App& program) {
  auto* verb = add_verb(program, "merge",
                        "A bracketed set of photographs becomes one of the scene's luminance");
  const auto options = std::make_shared<Options>();
  add_flag(*verb, "photographs,--photographs", options->photographs,
           "of one scene, as --photograph writes them, .exr")
      .reads_file()
      .required();
  add_flag(*verb, "-o,--output", options->output, "scene-linear [cd/m2], .exr")
      .writes_file()
      .required();
  add_switch(*verb, "--json", options->json, "one JSON document on stdout");
  add_recipe_option(*verb);
  on_run(*verb, [options] { run(*options); });
}

}  // namespace coppermoon::verbs
