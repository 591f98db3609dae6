// SPDX-License-Identifier: MIT
#include "colour/working_space.h"

#include <strings.h>

#include <algorithm>
#include <cassert>
#include <cctype>
#include <cmath>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>

#include "algebra/error.h"
#include "colour/camera_spectra.h"
#include "colour/cie_observer.h"

namespace coppermoon::colour {
namespace {

constexpr std::array all_spaces{WorkingSpace::linear_rec709, WorkingSpace::acescg,
                                WorkingSpace::ciexyz_d65};

struct Primaries {
  glm::dvec2 red, green, blue, white;
};

constexpr glm::dvec2 d65{0.3127, 0.3290};

/// Names of a space, its main name first, and the chromaticities of its primaries and white.
struct Space {
  std::array<std::string_view, 3> names;
  Primaries primaries;
};

/// Names and primaries of all working spaces, indexed by WorkingSpace.
constexpr std::array<Space, 3> spaces{
    {{{"lin_rec709", "lin_rec709_scene", "lin_srgb"},
      {{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, d65}},
     {{"acescg", "lin_ap1", "lin_ap1_scene"},
      {{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, {0.32168, 0.33767}}},
     {{"lin_ciexyzd65_scene", "ciexyzd65"}, {{1, 0}, {0, 1}, {0, 0}, {1.0 / 3, 1.0 / 3}}}}};

const Space& about(WorkingSpace space) { return spaces[static_cast<std::size_t>(space)]; }

glm::dvec3 direction_of(glm::dvec2 xy) { return {xy.x, xy.y, 1 - xy.x - xy.y}; }

/// XYZ of a colour with the given chromaticity and luminance 1.
glm::dvec3 unit_xyz(glm::dvec2 xy) { return direction_of(xy) / xy.y; }

glm::dmat3 xyz_from_rgb(const Primaries& p) {
  const glm::dmat3 axes(direction_of(p.red), direction_of(p.green), direction_of(p.blue));
  const glm::dvec3 scale = glm::inverse(axes) * unit_xyz(p.white);
  return {axes[0] * scale.x, axes[1] * scale.y, axes[2] * scale.z};
}

/// Chromatic adaptation from one white to another, with Bradford's cone responses.
glm::dmat3 adaptation(glm::dvec2 from_white, glm::dvec2 to_white) {
  const glm::dmat3 cones = glm::transpose(
      glm::dmat3{0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296});
  const auto gain = (cones * unit_xyz(to_white)) / (cones * unit_xyz(from_white));
  return glm::inverse(cones) * glm::dmat3{gain.x, 0, 0, 0, gain.y, 0, 0, 0, gain.z} * cones;
}

struct Matrices {
  glm::dmat3 channels_from_xyz, xyz_from_channels;
};

Matrices derived(WorkingSpace space) {
  if (space == WorkingSpace::ciexyz_d65) return {glm::dmat3(1), glm::dmat3(1)};
  const auto primaries = about(space).primaries;
  const auto rgb_from_xyz =
      glm::inverse(xyz_from_rgb(primaries)) * adaptation(d65, primaries.white);
  return {rgb_from_xyz, glm::inverse(rgb_from_xyz)};
}

const Matrices& matrices(WorkingSpace space) {
  static const std::array<Matrices, 3> each{derived(all_spaces[0]), derived(all_spaces[1]),
                                            derived(all_spaces[2])};
  return each[static_cast<std::size_t>(space)];
}

glm::dvec3 vector_of(std::span<const double> channels) {
  assert(channels.size() == 3);
  return {channels[0], channels[1], channels[2]};
}

/// The least share of grey that must be mixed into a colour so that no channel is negative.
double share_of_grey(const glm::dvec3& colour, const glm::dvec3& grey) {
  double share = 0;
  for (int i = 0; i < 3; ++i)
    if (colour[i] < 0) share = std::max(share, colour[i] / (colour[i] - grey[i]));
  return share;
}

/// Position of a word in a text, regardless of upper and lower case; npos if the word is absent.
std::size_t find_word(std::string_view text, std::string_view word) {
  const auto same = [](unsigned char a, unsigned char b) {
    return std::tolower(a) == std::tolower(b);
  };
  const auto found = std::search(text.begin(), text.end(), word.begin(), word.end(), same);
  return found == text.end() ? text.npos : static_cast<std::size_t>(found - text.begin());
}

}  // namespace

std::span<const std::string_view> aliases(WorkingSpace space) {
  const std::span names(about(space).names);
  return names.first(names.back().empty() ? 2 : 3);
}

std::string_view name(WorkingSpace space) { return aliases(space).front(); }

std::string_view interop_id(WorkingSpace space) {
  return *std::ranges::find_if(aliases(space),
                               [](std::string_view alias) { return alias.ends_with("_scene"); });
}

WorkingSpace working_space(std::string_view name_or_alias) {
  for (const auto space : all_spaces)
    for (const auto alias : aliases(space))
      if (::strcasecmp(alias.data(), std::string(name_or_alias).c_str()) == 0) return space;
  throw algebra::Error(fmt::format("working space \"{}\", allowed {}, {} or {}", name_or_alias,
                                   name(all_spaces[0]), name(all_spaces[1]), name(all_spaces[2])));
}

std::optional<WorkingSpace> space_in_name(std::string_view file_name) {
  for (const auto space : all_spaces)
    for (const auto alias : aliases(space))
      if (find_word(file_name, alias) != file_name.npos) return space;
  return std::nullopt;
}

bool names_another_space(std::string_view file_name) {
  if (space_in_name(file_name)) return false;
  const auto has_word = [&](const char* start) {
    const auto found = find_word(file_name, start);
    return found != file_name.npos &&
           (found == 0 || !std::isalnum(static_cast<unsigned char>(file_name[found - 1])));
  };
  return std::ranges::any_of(std::array{"aces", "ap0", "ap1", "rec2020", "p3", "xyz"}, has_word);
}

glm::dmat3 channels_from_xyz(WorkingSpace space) { return matrices(space).channels_from_xyz; }

algebra::Grid<double> channel_weights(WorkingSpace space, std::span<const double> edges_nm,
                                      const std::string& response) {
  auto weights = is_spectral(response) ? xyz_weights(edges_nm, camera_spectra(response))
                                       : xyz_weights(edges_nm);
  const auto& matrix = matrices(space).channels_from_xyz;
  for (std::size_t band = 0; band < weights.columns(); ++band) {
    const auto channels = matrix * glm::dvec3(weights(0, band), weights(1, band), weights(2, band));
    for (int i = 0; i < 3; ++i) weights(static_cast<std::size_t>(i), band) = channels[i];
  }
  return weights;
}

std::array<float, 8> chromaticities(WorkingSpace space) {
  const auto p = about(space).primaries;
  std::array<float, 8> xy{};
  std::size_t i = 0;
  for (const auto& point : {p.red, p.green, p.blue, p.white})
    for (const double coordinate : {point.x, point.y}) xy[i++] = static_cast<float>(coordinate);
  return xy;
}

double luminance(WorkingSpace space, std::span<const double> channels) {
  return (matrices(space).xyz_from_channels * vector_of(channels)).y;
}

double brightest_channel(WorkingSpace space, std::span<const double> channels) {
  using enum WorkingSpace;
  if (space == linear_rec709) return std::ranges::max(channels);
  static const auto rec709 = [] {
    std::array<glm::dmat3, 3> from{};
    for (const auto each : all_spaces)
      from[static_cast<std::size_t>(each)] =
          matrices(linear_rec709).channels_from_xyz * matrices(each).xyz_from_channels;
    return from;
  }();
  const auto rgb = rec709[static_cast<std::size_t>(space)] * vector_of(channels);
  return std::max({rgb.x, rgb.y, rgb.z});
}

glm::dvec3 white(WorkingSpace space) { return matrices(space).channels_from_xyz * unit_xyz(d65); }

void into_gamut(WorkingSpace space, std::span<double> channels) {
  const auto colour = vector_of(channels);
  for (const double c : channels)
    if (!std::isfinite(c))
      throw algebra::Error(fmt::format("colour channel = {}, allowed finite", c));
  if (std::ranges::min(channels) >= 0) return;
  const double Y = luminance(space, channels);
  if (Y < 0) throw algebra::Error(fmt::format("luminance [cd/m²] = {:g}, allowed 0 or more", Y));
  const auto grey = Y * white(space);
  const double share = share_of_grey(colour, grey);
  for (int i = 0; i < 3; ++i)
    channels[static_cast<std::size_t>(i)] =
        std::max(0.0, colour[i] + share * (grey[i] - colour[i]));  // below 0 only due to rounding
}

}  // namespace coppermoon::colour
