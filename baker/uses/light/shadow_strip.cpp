// SPDX-License-Identifier: MIT
#include "uses/light/shadow_strip.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <glm/matrix.hpp>

#include "algebra/error.h"
#include "almanac/instant.h"
#include "eclipse/shadow_axis.h"
#include "files/own_file.h"
#include "files/whole_file.h"
#include "texture/write_image.h"
#include "uses/light/header.h"

#include "uses/light/spectral_bands.h"

namespace coppermoon::uses {
namespace {

namespace fs = std::filesystem;

using nlohmann::ordered_json;

constexpr std::size_t columns = 1024;
constexpr double moon_radius_m = algebra::in_metres(almanac::lunar_radius);

struct Strip {
  texture::Image light;
  double end_m;

  double step_m() const { return end_m / (columns - 1); }
};

shadow::RefractedLight light_of(const StripShadow& shadow, const LightRequest& request,
                                const std::vector<double>& waves,
                                const algebra::Progress& progress) {
  constexpr double spacing_m = 25e3;
  constexpr std::size_t around = 96;
  const auto& arrangement = shadow.arrangement;
  const double reach_m =
      shadow::refracted_reach_m(arrangement, shadow.air, arrangement.depths_m[0]);
  std::vector<double> distances_m;
  for (double d = 0; d < reach_m + spacing_m; d += spacing_m) distances_m.push_back(d);
  return refracted_light(request, shadow.air, arrangement, {waves, distances_m, around}, progress);
}

Strip strip_of(const StripShadow& shadow, const LightRequest& request,
               const algebra::Progress& progress) {
  const int bands = request.by_hand.bands.value_or(100);
  const auto waves = wavelengths_nm(bands);
  const double depth_m = shadow.arrangement.depths_m[0];
  const auto refracted = light_of(shadow, request, waves, progress);
  const shadow::DirectLight direct(shadow.air, shadow.arrangement, waves);
  const auto weights = moonlight_weights(
      colour::channel_weights(picture_space, band_edges_nm(), shadow.response.value_or("")));
  shadow::Lookup lookup(refracted, direct, at_wavelengths(weights, bands));
  lookup.transform([](std::span<double> colour) { into_gamut_or_black(picture_space, colour); });
  const std::size_t rows = refracted.sectors;
  Strip strip{{columns, rows, {"R", "G", "B"}}, direct.penumbra_m(depth_m)};
  std::array<double, 3> here, sunlight;
  lookup.read({algebra::metres(2 * strip.end_m), {}, algebra::metres(depth_m)}, sunlight);
  std::ranges::fill(strip.light.values, 1.F);  // the last column stays so
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c + 1 < columns; ++c) {
      const double angle = shadow::Sectors{rows}.angle_rad(r);
      lookup.read({algebra::metres(static_cast<double>(c) * strip.step_m()),
                   algebra::radians(angle), algebra::metres(depth_m)},
                  here);
      for (std::size_t k = 0; k < 3; ++k)
        strip.light(r, c, k) = static_cast<float>(here[k] / sunlight[k]);
    }
  return strip;
}

ordered_json as_json(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

/// Shadow axis at its nearest point to the Moon, with the shadow frame.
ordered_json axis_of(const almanac::SkyState& sky) {
  const auto axis = eclipse::shadow_axis(sky);
  const auto centre_m = axis.shadow_from_gcrs * sky.moon_m;
  const auto frame = sky.selenographic_from_gcrs * glm::transpose(axis.shadow_from_gcrs);
  return {{"instant", almanac::utc_text(sky.when)},
          {"axis_point_lunar_radii",
           as_json(-(centre_m.x * frame[0] + centre_m.y * frame[1]) / moon_radius_m)},
          {"axis_point_depth_lunar_radii", centre_m.z / moon_radius_m},
          {"axis_direction", as_json(frame[2])},
          {"axis_east", as_json(frame[0])},
          {"axis_north", as_json(frame[1])}};
}

ordered_json facts_of(const std::filesystem::path& file, const Strip& strip,
                      const StripShadow& shadow, const std::string& recipe) {
  const double depth_m = shadow.arrangement.depths_m[0];
  ordered_json facts{{"texture", file.filename().string()},
                     {"colour_space", colour::name(picture_space)},
                     {"columns", strip.light.width},
                     {"rows", strip.light.height},
                     {"end_km", strip.end_m / 1e3},
                     {"step_km", strip.step_m() / 1e3},
                     {"depth_km", depth_m / 1e3},
                     {"sun_distance_km", shadow.arrangement.sun_distance_m / 1e3},
                     {"lunar_radius_km", moon_radius_m / 1e3},
                     {"end_lunar_radii", strip.end_m / moon_radius_m},
                     {"step_lunar_radii", strip.step_m() / moon_radius_m},
                     {"depth_lunar_radii", depth_m / moon_radius_m},
                     {"limb_lunar_radii", shadow::limb_m / moon_radius_m},
                     {"one_limb_lunar_radii", shadow::one_limb_m / moon_radius_m}};
  if (shadow.sky) facts.update(axis_of(*shadow.sky));
  facts["version"] = version();
  facts["recipe"] = recipe;
  return facts;
}

/// Facts of the strip as attributes of a header.
texture::Attributes header(const ordered_json& facts) {
  texture::Attributes attributes;
  say_space(attributes, picture_space);
  for (const auto& [key, value] : facts.items()) {
    if (key == "texture") continue;  // a file may be renamed
    auto& attribute = attributes["coppermoon:" + key];
    if (value.is_string()) attribute = value.get<std::string>();
    if (value.is_number()) attribute = value.get<float>();
    if (value.is_number_integer()) attribute = value.get<int>();
    if (value.is_array()) attribute = value.get<std::vector<float>>();
  }
  return attributes;
}

std::string as_cube(const Strip& strip) {
  const double end = strip.end_m / moon_radius_m;
  auto text = fmt::format(
      "TITLE \"light in the Earth's shadow over sunlight, lin_rec709\"\n"
      "# in: distance from the shadow's axis, in lunar radii\n"
      "LUT_1D_SIZE {}\nDOMAIN_MIN 0 0 0\nDOMAIN_MAX {} {} {}\n",
      columns, end, end, end);
  for (std::size_t c = 0; c < columns; ++c)
    text +=
        fmt::format("{} {} {}\n", strip.light(0, c, 0), strip.light(0, c, 1), strip.light(0, c, 2));
  return text;
}

void require_kind(const std::filesystem::path& file, const atmosphere::Atmosphere& air) {
  if (file.extension() != ".exr" && file.extension() != ".cube")
    throw algebra::Error(fmt::format("{}: a look-up ends in .exr or .cube", file.string()));
  if (file.extension() == ".cube" && !air.symmetric())
    throw algebra::Error(
        fmt::format("{}: a .cube has one row, and this shadow differs around its axis; allowed "
                    "with a spherical Earth and one air all around, as undated, or .exr",
                    file.string()));
}

/// Refuses a .json beside the strip that is not of a strip: it is somebody else's.
void require_ours(const fs::path& beside, const fs::path& strip) {
  files::require_no_link(beside);
  if (!fs::exists(beside)) return;
  const auto facts = ordered_json::parse(files::bytes_of(beside), nullptr, false);
  const bool tells = facts.is_object() && facts.contains("texture") && facts["texture"].is_string();
  if (!tells || fs::path(facts["texture"].get<std::string>()).stem() != strip.stem())
    throw algebra::Error(
        fmt::format("{}: tells of no strip {}, and would be overwritten; allowed another name",
                    beside.string(), strip.filename().string()));
}

}  // namespace

ordered_json write_shadow_strip(const std::filesystem::path& file, const StripShadow& shadow,
                                const LightRequest& request, const std::string& recipe,
                                const algebra::Progress& progress) {
  require_kind(file, shadow.air);
  files::require_place_for(file);
  const auto beside = fs::path(file).replace_extension(".json");
  require_ours(beside, file);
  const auto strip = strip_of(shadow, request, progress);
  auto facts = facts_of(file, strip, shadow, recipe);
  if (file.extension() == ".cube")
    files::write_whole(file, as_cube(strip));
  else
    texture::write_exr(file, strip.light, header(facts), {texture::ExrType::floating});
  files::write_whole(beside, facts.dump(2) + "\n");
  return facts;
}

}  // namespace coppermoon::uses
