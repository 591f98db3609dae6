// SPDX-License-Identifier: MIT
#include "verbs/flags/known_words.h"

#include <algorithm>

#include "request/likeness.h"

namespace coppermoon::verbs {
namespace {

/// A flag or command of coppermoon, and the names that other programs use for it, separated by spaces.
struct Meaning {
  std::string_view here, elsewhere;
};

constexpr Meaning flags_elsewhere[] = {
    {"field", "fov field-of-view zoom"},
    {"time", "exposure exposure-time shutter shutter-speed"},
    {"output", "out outfile output-file output-dir format folder outdir output-folder"},
    {"at", "location place city observer where lat latitude lon longitude elevation position"},
    {"instant", "date when datetime moment"},
    {"width", "size resolution"},
    {"texture-width", "width size resolution texture-size"},
    {"camera", "lens telescope"},
    {"iso", "iso-speed gain"},
    {"f-number", "aperture-number fstop f-stop"},
    {"albedo-map", "map albedo texture"},
    {"space", "colorspace colourspace colour-space color-space"},
    {"tolerance", "accuracy error"},
    {"photons", "samples rays spp"},
    {"atmosphere", "air"},
    {"recipe", "config preset"},
    {"threads", "jobs cores workers cpus"},
    {"fps", "framerate frame-rate"},
    {"movie", "video mp4"},
    {"from", "start start-time since"},
    {"to", "end end-time until"},
    {"feature", "crater"},
    {"mount", "tripod"},
    {"replace", "force overwrite"},
    {"cloud-cover", "clouds cloud"},
    {"dust-extinction", "dust"},
    {"ozone-du", "ozone"},
    {"stratospheric-aerosol", "aerosol volcano"},
    {"tropospheric-aerosol", "haze"},
    {"water-vapour", "water humidity"},
    {"zone", "timezone time-zone tz"},
    {"eclipse", "day date when"},
    {"focal-length", "focal"},
    {"sensor-width", "sensor"},
    {"bracket", "ev"},
    {"stars", "magnitude"},
    {"sky", "background"},
    {"up", "orientation rotation"},
    {"bits", "depth bit-depth"},
    {"view", "tonemap tone-mapping look"},
    {"config", "ocio"},
    {"duration", "length"},
    {"time-scale", "speed"},
    {"danjon", "danjon-scale red"},
};

/// Flags of earlier versions that no longer exist, and advice on what to use instead.
constexpr std::pair<std::string_view, std::string_view> flags_before[] = {
    {"precision", "photons are no longer marched; --tolerance says how exact light is to be"},
    {"trace", "the solver photons goes by a table, literal steps each photon as in the paper"},
    {"lookup", "coppermoon shader writes the shadow of a moment, or of an eclipse, for shaders"},
};

constexpr Meaning verbs_elsewhere[] = {
    {"still", "render picture image photo simulate photograph png"},
    {"animate", "film movie animation video timelapse"},
    {"bake", "texture usd map"},
    {"sky", "info ephemeris where position moon"},
    {"almanac", "eclipses list find calendar next when"},
    {"brightness", "magnitude photometry luminance"},
    {"shadow", "profile umbra"},
    {"scene", "pov"},
    {"merge", "hdr stack bracket"},
    {"plan", "estimate cost"},
    {"tradeoff", "benchmark"},
    {"night", "tonight visibility forecast"},
    {"dome", "skydome panorama hdri environment"},
    {"ring", "sunset"},
    {"shader", "glsl osl"},
    {"explore", "web html page"},
    {"compare", "diff measure"},
    {"fit", "solve retrieve"},
    {"develop", "tonemap expose"},
    {"describe", "schema options parameters"},
    {"cache", "clean"},
};

bool lists(std::string_view words, std::string_view word) {
  return (" " + std::string(words) + " ").find(" " + std::string(word) + " ") != std::string::npos;
}

template <std::size_t count>
std::string suggested(std::string_view word, const Meaning (&meanings)[count],
                      const std::vector<std::string>& known, const char* dashes) {
  for (const auto& [here, elsewhere] : meanings)
    if (lists(elsewhere, word) && holds(known, here))
      return "; did you mean " + std::string(dashes) + std::string(here) + "?";
  const auto like = request::nearest(word, known);
  const auto apart = request::letters_apart(word.substr(0, 100), like);
  const bool alike = apart <= 2 && 3 * apart <= like.size() + 1;
  return alike ? "; did you mean " + std::string(dashes) + like + "?" : "";
}

}  // namespace

std::vector<std::string> names_of(const Verb& verb) {
  std::vector<std::string> names;
  for (const auto* parameter : flags_of(verb)) names.push_back(parameter->name);
  return names;
}

bool holds(const std::vector<std::string>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string_view since_there_is_no(std::string_view flag) {
  for (const auto& [before, now] : flags_before)
    if (flag == before) return now;
  return {};
}

std::string flag_suggested_for(std::string_view flag, const std::vector<std::string>& known) {
  if (const auto now = since_there_is_no(flag); !now.empty()) return fmt::format("; {}", now);
  return suggested(flag, flags_elsewhere, known, "--");
}

std::string verb_suggested_for(std::string_view verb, const std::vector<std::string>& known) {
  return suggested(verb, verbs_elsewhere, known, "");
}

}  // namespace coppermoon::verbs
