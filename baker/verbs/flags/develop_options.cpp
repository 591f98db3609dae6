// SPDX-License-Identifier: MIT
#include "verbs/flags/develop_options.h"

#include <fmt/format.h>

#include "algebra/error.h"
#include "verbs/flags/camera_options.h"
#include "verbs/flags/moments.h"

namespace coppermoon::verbs {
namespace {

constexpr const char* time_help =
    "exposure time [s], as 2 or 1/30; auto: exposes the brightest 1 % of the lit disc to 80 % of "
    "saturation; follow: a weighted mean of the disc is exposed to 25 %, without a step in a film; "
    "composite: a short one for what is bright and a long one for the shadow, in one picture";

std::string text_of(const uses::ExposureTime& time) {
  using enum uses::ExposureTime::Rule;
  if (time.rule == automatic) return "auto";
  if (time.rule == follow) return "follow";
  return time.rule == composite ? "composite" : fmt::format("{}", time.seconds);
}

}  // namespace

uses::ExposureTime exposure_time_from(const std::string& text) {
  using enum uses::ExposureTime::Rule;
  if (text == "auto") return {automatic};
  if (text == "follow") return {follow};
  if (text == "composite") return {composite};
  const auto seconds = exposure_seconds(text);
  if (!seconds)
    throw algebra::Error(fmt::format(
        "exposure time = {}, allowed auto, follow, composite, or 1e-6 to 1e6 s, as 2 or 1/30",
        text));
  return {fixed, *seconds};
}

void add_time_option(CLI::App& verb, std::string& time) {
  add_flag(verb, "--time", time, time_help).in(camera_group);
}

void add_picture_options(CLI::App& verb, uses::Development& development) {
  const std::string group = camera_group;
  add_flag(verb, "--f-number", development.f_number,
           "focal length over aperture; default: the camera's, without one 12.1")
      .in(group);
  add_flag(verb, "--iso", development.iso, "ISO speed (ISO 12232, saturation-based)").in(group);
  add_flag(verb, "--view", development.view, "view of the OpenColorIO configuration").in(group);
  add_flag(verb, "--display", development.display, "display of the OpenColorIO configuration")
      .in(group);
  add_flag(verb, "--config", development.config,
           "OpenColorIO configuration in place of the built-in one")
      .reads_file()
      .in(group);
  add_flag(verb, "--bits", development.bits, "bits of a number of the picture")
      .one_of({"8", "16"})
      .in(group);
}

void add_develop_options(CLI::App& verb, uses::Development& development) {
  auto& time = development.time;
  add_parsed(
      verb, "--time", [&time](const std::string& text) { time = exposure_time_from(text); },
      time_help, text_of(time))
      .in(camera_group);
  add_picture_options(verb, development);
}

}  // namespace coppermoon::verbs
