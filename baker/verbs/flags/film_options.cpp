// SPDX-License-Identifier: MIT
#include "verbs/flags/film_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "algebra/error.h"
#include "algebra/number.h"
#include "almanac/calendar.h"
#include "eclipse/moment.h"
#include "uses/picture/picture_parameters.h"
#include "uses/picture/place_text.h"
#include "verbs/flags/moments.h"

namespace coppermoon::verbs {
namespace {

using almanac::Instant;
using request::Affects, request::parameter;

const std::vector<std::pair<std::string, uses::Mount>> mounts{{"tracking", uses::Mount::tracking},
                                                              {"horizon", uses::Mount::horizon},
                                                              {"fixed", uses::Mount::fixed}};

struct ProductWord {
  std::string_view word;
  bool uses::Products::*product;
};

/// Words that --make accepts, and the products that they select.
constexpr ProductWord product_words[]{
    {"light", &uses::Products::light},   {"scenes", &uses::Products::scenes},
    {"tx", &uses::Products::mipmapped},  {"textures", &uses::Products::textures},
    {"frames", &uses::Products::frames}, {"pictures", &uses::Products::pictures}};

/// Converts a duration such as "10", "10s" or "2min" to a number of seconds, as text.
std::string duration_as_seconds(const std::string& text) {
  const auto seconds =
      algebra::number_with_unit(text, {{"min", 60}, {"h", 3600}, {"s", 1}, {"", 1}});
  if (!seconds)
    throw algebra::Error(
        fmt::format("duration = {}, allowed 0.001 to 1e6 s, as 10, 10s or 2min", text));
  return request::text_of(*seconds);
}

/// Adds a parameter under the heading "The film".
request::Parameter& add(Verb& verb, request::Parameter made, Affects affects = Affects::ground) {
  return add_flag(verb, std::move(made)).in("The film").of(affects);
}

void add_times(Verb& verb, FilmOptions& options) {
  add(verb, parameter("eclipse,--eclipse", options.eclipse,
                      "day of the eclipse, as 2018-07-27; or a file of a film, to go on with it"));
  add_calendar_option(verb, options.calendar);
  add_zone_option(verb, options.zone);
  const std::string moments =
      "moment in UTC, or a contact: P1, U1, U2, greatest, U3, U4, P4, as P1-10min or U2+90s; or ";
  add(verb,
      parameter("--from", options.from,
                moments + "moonrise: P1, or where the Moon rises later at the place of --at, its "
                          "rise; by default P1 means the same"));
  add(verb,
      parameter("--to", options.to,
                moments + "moonset: P4, or where the Moon sets before at the place of --at, its "
                          "set; by default P4 means the same"));
  add(verb, parameter("--frames", options.frames,
                      "number of frames, 1 to 1000000, evenly from the first moment to the last; "
                      "default: 240"))
      .within(1, 1e6);
  add(verb, parameter("--fps", options.fps,
                      "frames per second of the film, 1 to 1000, as 24, 24000/1001, or 23.976, "
                      "29.97 and 59.94, which mean ratios with 1001"))
      .as(request::Kind::number)
      .within(1, 1000)
      .spelt_by([](const std::string& text) { return text_of(uses::frame_rate_from(text)); });
  add(verb, parameter("--time-scale", options.time_scale,
                      "seconds of the eclipse per second of the film, 0.001 to 1e6, in place of "
                      "--frames"))
      .within(0.001, 1e6);
  add(verb, parameter("--duration", options.duration_s,
                      "length of the film [s], 0.001 to 1e6, or as 10s or 2min, in place of "
                      "--frames: as many frames as --fps has in it"))
      .within(0.001, 1e6)
      .spelt_by(duration_as_seconds);
  add(verb, parameter("--moments", options.moments,
                      "moments of the frames, with commas between, in order of time, as "
                      "U1,U2+5min,greatest, in place of --from, --to and --frames"));
  add(verb,
      parameter("--start-frame", options.start_frame,
                "number of the first frame, 0 to 1000000, in names of files, --range and the "
                "stage; default: 1"),
      Affects::sight)
      .within(0, 1e6);
}

/// Reads a list of moments separated by commas.
///
/// Throws  Error  if a moment cannot be read
std::vector<Instant> moments_in(const std::string& text, const eclipse::Eclipse& eclipse,
                                const uses::MomentContext& context) {
  std::vector<Instant> moments;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');)
    moments.push_back(uses::moment_from(part, eclipse, context));
  return moments;
}

void add_making(Verb& verb, FilmOptions& options) {
  add(verb,
      parameter("--make", options.make,
                "what to make, with commas between: textures, scenes (with their textures), frames "
                "(scene-linear), pictures; tx (textures tiled and mip-mapped, .tx) alone; or light "
                "alone, which they all need. Files of the whole film add what they are made of"),
      Affects::share);
  add(verb, parameter("--range", options.range, "frames to make, as 1-240, 1-240x2 or 7,9,20-30"),
      Affects::share);
  add(verb,
      parameter("--shard", options.shard,
                "share of the work, K/N: every N-th frame from the K-th on; with --make light, "
                "that part of the photons"),
      Affects::share);
  add(verb,
      request::choice("--mount", options.mount, mounts,
                      "mount of the camera: tracking (the Moon stays in the middle), horizon (the "
                      "same, zenith up) or fixed (on a tripod, zenith up)"),
      Affects::frame);
  add(verb,
      parameter("--aim", options.aim,
                "ALTITUDE,AZIMUTH that a fixed mount points at [degrees, azimuth from north "
                "through east]; default: where the Moon is half way"),
      Affects::frame);
  add(verb,
      parameter("--scene", options.scene,
                "POV-Ray scene of your own, .pov: each frame is this scene beside moon.inc, sky "
                "and stars of its moment (see `coppermoon scene`), with frame_number and a clock "
                "from 0 to 1"),
      Affects::frame)
      .reads_file();
  add(verb,
      parameter("--bracket", options.bracket_ev,
                "stops: pictures so much under and over are made too, 0.01 to 10"),
      Affects::picture)
      .within(0.01, 10);
}

void add_files_of_all(Verb& verb, FilmOptions& options) {
  const auto add_file = [&](const char* flag, auto& file, const char* text) {
    add_flag(verb, flag, file, text).writes_file().in("Of the whole film");
  };
  add_file("--contact-sheet", options.files.contact_sheet,
           "contact sheet, .png: some 40 pictures, those at the contacts among them, with their "
           "times");
  add_file("--curve", options.files.curves,
           "light curve, .csv, .png, .svg or .pdf: V magnitude and mean luminance of the disc "
           "above the air. May be given again");
  add_file("--movie", options.files.movie,
           "movie of the pictures, made by ffmpeg: .mp4 (H.264), or .mov (ProRes 422 HQ) for "
           "editing");
  add_switch(verb, "--hdr", options.hdr,
             "makes pictures of high dynamic range too (PQ, Rec.2020, frame_hdr.0001.png), and the "
             "movie of them: HDR10 in HEVC, .mp4; or PQ in ProRes, .mov")
      .in("Of the whole film")
      .of(Affects::share);
  add_file("--composite", options.files.composite,
           "picture of all linear frames together, .png, each with its own exposure");
  add_file("--stage", options.files.stage,
           "stage of USD among the textures, .usda: the Moon by one shader or by its textures, "
           "camera, moonlight and contacts");
}

constexpr double half_a_month_s = 15 * 86400.;

/// The eclipse nearest to a moment.
///
/// Throws  Error  if that eclipse is more than 15 days away
eclipse::Eclipse eclipse_near(const std::string& text, almanac::Calendar calendar) {
  const auto moment = almanac::instant_from_utc(text, calendar);
  auto nearest = eclipse::nearest_eclipse(moment, eclipse::ShadowConvention::danjon);
  if (std::abs(almanac::seconds_between(moment, nearest.greatest)) > half_a_month_s)
    throw algebra::Error(
        fmt::format("no lunar eclipse within 15 days of {}; the nearest is greatest at {}", text,
                    almanac::utc_text(nearest.greatest, calendar)));
  nearest.calendar = calendar;
  return nearest;
}

}  // namespace

void add_film_options(Verb& verb, FilmOptions& options) {
  add_times(verb, options);
  add_making(verb, options);
  add_files_of_all(verb, options);
}

eclipse::Eclipse eclipse_of(const FilmOptions& options,
                            const std::optional<almanac::Observer>& observer) {
  if (eclipse::is_day(options.eclipse)) {
    const auto found =
        uses::eclipse_of_day(options.eclipse, {observer, options.zone, options.calendar});
    if (found) return *found;
    const auto nearest = eclipse_near(options.eclipse, options.calendar);
    fmt::print(stderr, "coppermoon: no eclipse is greatest on {}; the nearest, at {}, is taken\n",
               options.eclipse, almanac::utc_text(nearest.greatest, options.calendar));
    return nearest;
  }
  for (const auto& text : {options.eclipse, options.from, options.to,
                           options.moments.substr(0, options.moments.find(','))})
    if (eclipse::begins_with_digit(text)) return eclipse_near(text, options.calendar);
  // This call is made only for its error, whose message gives the allowed forms of a date.
  if (!options.eclipse.empty()) almanac::instant_from_utc(options.eclipse);
  throw algebra::Error(
      fmt::format("from {} to {} of which eclipse? Name a day near it, as 2018-07-27", options.from,
                  options.to));
}

uses::FilmTimes times_of(const FilmOptions& options, const uses::ViewRequest& view) {
  if (!options.moments.empty() && (options.from != "P1" || options.to != "P4"))
    throw algebra::Error(
        fmt::format("moments = {}, allowed without --from and --to", options.moments));
  const auto eclipse = eclipse_of(options, view.observer);
  const uses::MomentContext context{view.observer, options.zone, options.calendar};
  const bool rise = view.observer && options.from == "moonrise",
             set = view.observer && options.to == "moonset";
  auto from = uses::moment_from(rise ? "P1" : options.from, eclipse, context),
       to = uses::moment_from(set ? "P4" : options.to, eclipse, context);
  if (almanac::seconds_between(from, to) < 0)
    throw algebra::Error(fmt::format("--from {} is later than --to {}", options.from, options.to));
  if (rise || set) {
    const auto [first, last] = uses::while_up(view, from, to);
    if (rise) from = first;
    if (set) to = last;
  }
  return {.eclipse = eclipse,
          .from = from,
          .to = to,
          .frames = options.frames,
          .fps = options.fps,
          .time_scale = options.time_scale,
          .duration_s = options.duration_s,
          .moments = moments_in(options.moments, eclipse, context),
          .first_frame = options.start_frame.value_or(1)};
}

void keep_to_the_moon(uses::FilmTimes& times, request::Parameters& parameters,
                      const uses::ViewRequest& view) {
  auto &from = *parameters.find("from"), &to = *parameters.find("to");
  if (!view.observer || !times.moments.empty() || (from.given && to.given)) return;
  const auto [first, last] = uses::while_up(view, times.from, times.to);
  const auto keep = [&](request::Parameter& parameter, almanac::Instant& when, const char* word,
                        const almanac::Instant& edge) {
    const bool changes = !parameter.given && std::abs(almanac::seconds_between(when, edge)) > 1;
    if (changes) parameter.take({word});
    if (changes) when = edge;
    return changes;
  };
  const bool rises = keep(from, times.from, "moonrise", first);
  if (!keep(to, times.to, "moonset", last) && !rises) return;
  const auto text = [](const request::Parameter& parameter, const almanac::Instant& when) {
    return fmt::format("{}, {:.5} UTC", parameter.text(), almanac::time_of_day_text(when));
  };
  fmt::print(stderr, "coppermoon: from {}, to {}\n", text(from, times.from), text(to, times.to));
}

uses::Products products_of(const FilmOptions& options) {
  uses::Products products{.high_range = options.hdr};
  std::istringstream names(options.make);
  for (std::string name; std::getline(names, name, ',');) {
    const auto* known = std::ranges::find(product_words, name, &ProductWord::word);
    if (known == std::end(product_words))
      throw algebra::Error(
          fmt::format("make = {}, allowed light, textures, tx, scenes, frames and pictures, with "
                      "commas between",
                      options.make));
    products.*known->product = true;
  }
  const auto& files = options.files;
  products.textures |= products.scenes || products.mipmapped || !files.stage.empty();
  products.frames |= !files.composite.empty();
  products.pictures |= !files.movie.empty() || !files.contact_sheet.empty();
  if (options.hdr && !products.pictures)
    throw algebra::Error("--hdr is of pictures, allowed with pictures among --make");
  return products;
}

std::vector<std::pair<Instant, double>> time_keys_from(const std::string& text,
                                                       const eclipse::Eclipse& eclipse,
                                                       const uses::MomentContext& context) {
  std::vector<std::pair<Instant, double>> keys;
  if (text.find(':') == std::string::npos) return keys;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const auto colon = part.rfind(':');
    const auto seconds =
        colon == std::string::npos ? std::nullopt : uses::exposure_seconds(part.substr(colon + 1));
    if (!seconds)
      throw algebra::Error(fmt::format(
          "exposure time = {}, allowed keys as P1:1/1000,U2:4: a moment and seconds", text));
    algebra::require_within("exposure time [s]", *seconds, 1e-6, 1e6);
    keys.emplace_back(uses::moment_from(part.substr(0, colon), eclipse, context), *seconds);
  }
  for (std::size_t i = 1; i < keys.size(); ++i)
    if (almanac::seconds_between(keys[i - 1].first, keys[i].first) <= 0)
      throw algebra::Error(fmt::format("exposure time = {}, allowed keys in order of time", text));
  return keys;
}

uses::Mounting mounting_of(const FilmOptions& options, bool observed) {
  if (options.mount != uses::Mount::fixed && !options.aim.empty())
    throw algebra::Error(fmt::format("mount = {}: --aim needs a fixed one",
                                     request::word_for(mounts, options.mount)));
  if (options.mount == uses::Mount::fixed && !observed)
    throw algebra::Error("mount = fixed: needs --at");
  uses::Mounting mounting{.mount = options.mount};
  if (!options.aim.empty()) mounting.aim = uses::aim_from(options.aim);
  return mounting;
}

std::string make_text(const uses::Products& products) {
  std::vector<std::string_view> names;
  for (const auto& [word, product] : product_words)
    if (products.*product && !(word == "textures" && (products.scenes || products.mipmapped)))
      names.push_back(word);
  return fmt::format("{}", fmt::join(names, ","));
}

void require_whole_film(const FilmOptions& options) {
  const auto& [sheet, movie, composite, stage, curves] = options.files;
  const char* flag = !movie.empty()       ? "--movie"
                     : !sheet.empty()     ? "--contact-sheet"
                     : !composite.empty() ? "--composite"
                     : !stage.empty()     ? "--stage"
                     : !curves.empty()    ? "--curve"
                                          : nullptr;
  if (flag != nullptr && uses::shard_from(options.shard).parts > 1)
    throw algebra::Error(
        fmt::format("{} needs every frame: run it without --shard after all shards, which are made "
                    "with --make {}",
                    flag, make_text(products_of(options))));
  require_sound(options.files, {});
}

}  // namespace coppermoon::verbs
