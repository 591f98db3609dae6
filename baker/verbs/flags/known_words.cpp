// SPDX-License-Identifier: MIT
#include "verbs/flags/known_words.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "request/likeness.h"

namespace coppermoon::verbs {
namespace {

struct Meaning {
  std::string_view elsewhere, here;
};

/// Names of flags in other programs, and ours.
constexpr Meaning flags_elsewhere[] = {
    {"fov", "field"},
    {"field-of-view", "field"},
    {"zoom", "field"},
    {"exposure", "time"},
    {"exposure-time", "time"},
    {"shutter", "time"},
    {"shutter-speed", "time"},
    {"out", "output"},
    {"outfile", "output"},
    {"output-file", "output"},
    {"output-dir", "output"},
    {"location", "at"},
    {"place", "at"},
    {"city", "at"},
    {"observer", "at"},
    {"where", "at"},
    {"date", "instant"},
    {"when", "instant"},
    {"datetime", "instant"},
    {"size", "width"},
    {"resolution", "width"},
    {"width", "texture-width"},  // of what has no frame
    {"size", "texture-width"},
    {"resolution", "texture-width"},
    {"lens", "camera"},
    {"iso-speed", "iso"},
    {"aperture-number", "f-number"},
    {"fstop", "f-number"},
    {"f-stop", "f-number"},
    {"texture-size", "texture-width"},
    {"map", "albedo-map"},
    {"albedo", "albedo-map"},
    {"colorspace", "space"},
    {"colourspace", "space"},
    {"colour-space", "space"},
    {"color-space", "space"},
    {"accuracy", "tolerance"},
    {"error", "tolerance"},
    {"samples", "photons"},
    {"rays", "photons"},
    {"air", "atmosphere"},
    {"config", "recipe"},
    {"preset", "recipe"},
    {"jobs", "threads"},
    {"cores", "threads"},
    {"framerate", "fps"},
    {"frame-rate", "fps"},
    {"video", "movie"},
    {"start", "from"},
    {"end", "to"},
    {"crater", "feature"},
    {"tripod", "mount"},
    {"force", "replace"},
    {"overwrite", "replace"},
    {"clouds", "cloud-cover"},
    {"cloud", "cloud-cover"},
    {"dust", "dust-extinction"},
    {"ozone", "ozone-du"},
    {"aerosol", "stratospheric-aerosol"},
    {"volcano", "stratospheric-aerosol"},
    {"haze", "tropospheric-aerosol"},
    {"water", "water-vapour"},
    {"humidity", "water-vapour"},
    {"lat", "at"},
    {"latitude", "at"},
    {"lon", "at"},
    {"longitude", "at"},
    {"elevation", "at"},
    {"position", "at"},
    {"timezone", "zone"},
    {"time-zone", "zone"},
    {"tz", "zone"},
    {"day", "eclipse"},
    {"date", "eclipse"},
    {"when", "eclipse"},
    {"moment", "instant"},
    {"focal", "focal-length"},
    {"telescope", "camera"},
    {"sensor", "sensor-width"},
    {"gain", "iso"},
    {"ev", "bracket"},
    {"magnitude", "stars"},
    {"background", "sky"},
    {"orientation", "up"},
    {"rotation", "up"},
    {"depth", "bits"},
    {"bit-depth", "bits"},
    {"tonemap", "view"},
    {"tone-mapping", "view"},
    {"look", "view"},
    {"ocio", "config"},
    {"texture", "albedo-map"},
    {"spp", "photons"},
    {"workers", "threads"},
    {"cpus", "threads"},
    {"format", "output"},
    {"folder", "output"},
    {"outdir", "output"},
    {"output-folder", "output"},
    {"start-time", "from"},
    {"end-time", "to"},
    {"since", "from"},
    {"until", "to"},
    {"length", "duration"},
    {"speed", "time-scale"},
    {"mp4", "movie"},
    {"danjon-scale", "danjon"},
    {"red", "danjon"},
};

/// Flags of earlier versions, and what to do now.
constexpr Meaning flags_before[] = {
    {"precision", "photons are no longer marched; --tolerance says how exact light is to be"},
    {"trace", "the solver photons goes by a table, literal steps each photon as in the paper"},
    {"lookup", "coppermoon shader writes the shadow of a moment, or of an eclipse, for shaders"},
};

/// Names of commands in other programs, and ours.
constexpr Meaning verbs_elsewhere[] = {
    {"render", "still"},
    {"picture", "still"},
    {"image", "still"},
    {"photo", "still"},
    {"film", "animate"},
    {"movie", "animate"},
    {"animation", "animate"},
    {"video", "animate"},
    {"texture", "bake"},
    {"info", "sky"},
    {"ephemeris", "sky"},
    {"where", "sky"},
    {"eclipses", "almanac"},
    {"list", "almanac"},
    {"find", "almanac"},
    {"calendar", "almanac"},
    {"magnitude", "brightness"},
    {"profile", "shadow"},
    {"umbra", "shadow"},
    {"pov", "scene"},
    {"hdr", "merge"},
    {"estimate", "plan"},
    {"benchmark", "tradeoff"},
    {"simulate", "still"},
    {"photograph", "still"},
    {"png", "still"},
    {"timelapse", "animate"},
    {"next", "almanac"},
    {"when", "almanac"},
    {"tonight", "night"},
    {"visibility", "night"},
    {"forecast", "night"},
    {"position", "sky"},
    {"moon", "sky"},
    {"skydome", "dome"},
    {"panorama", "dome"},
    {"hdri", "dome"},
    {"environment", "dome"},
    {"sunset", "ring"},
    {"glsl", "shader"},
    {"osl", "shader"},
    {"web", "explore"},
    {"html", "explore"},
    {"page", "explore"},
    {"photometry", "brightness"},
    {"luminance", "brightness"},
    {"usd", "bake"},
    {"map", "bake"},
    {"stack", "merge"},
    {"bracket", "merge"},
    {"diff", "compare"},
    {"measure", "compare"},
    {"solve", "fit"},
    {"retrieve", "fit"},
    {"tonemap", "develop"},
    {"expose", "develop"},
    {"schema", "describe"},
    {"options", "describe"},
    {"parameters", "describe"},
    {"cost", "plan"},
    {"clean", "cache"},
};

template <std::size_t count>
std::string suggested(std::string_view word, const Meaning (&meanings)[count],
                      const std::vector<std::string>& known, const char* dashes) {
  for (const auto& [elsewhere, here] : meanings)
    if (word == elsewhere && holds(known, here))
      return "; did you mean " + std::string(dashes) + std::string(here) + "?";
  const auto like = request::nearest(word, known);
  const auto apart = request::letters_apart(word.substr(0, 100), like);
  const bool alike = apart <= 2 && 3 * apart <= like.size() + 1;
  return alike ? "; did you mean " + std::string(dashes) + like + "?" : "";
}

}  // namespace

std::vector<std::string> long_flags(const CLI::App& verb) {
  std::vector<std::string> flags;
  for (const auto* option : verb.get_options())
    for (const auto& name : option->get_lnames()) flags.push_back(name);
  return flags;
}

bool holds(const std::vector<std::string>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string_view since_there_is_no(std::string_view flag) {
  const auto found = std::ranges::find(flags_before, flag, &Meaning::elsewhere);
  return found == std::end(flags_before) ? std::string_view() : found->here;
}

std::string flag_suggested_for(std::string_view flag, const std::vector<std::string>& known) {
  if (const auto now = since_there_is_no(flag); !now.empty()) return fmt::format("; {}", now);
  return suggested(flag, flags_elsewhere, known, "--");
}

std::string verb_suggested_for(std::string_view verb, const std::vector<std::string>& known) {
  return suggested(verb, verbs_elsewhere, known, "");
}

}  // namespace coppermoon::verbs
