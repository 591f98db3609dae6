// SPDX-License-Identifier: MIT
#include "verbs/flags/guide.h"

namespace coppermoon::verbs {

const std::vector<GuideGroup>& guides() {
  static const std::vector<GuideGroup> groups{
      {"Pictures and textures",
       {{"still",
         {"at", "output", "field", "width", "height", "time", "camera", "danjon", "quality",
          "frame"},
         {"coppermoon still 2018-07-27 --at Nairobi -o moon.png",
          "coppermoon still 2018-07-27 U2+10min --at Nairobi --camera 400mm --time 2 -o moon.png"}},
        {"bake",
         {"output", "texture-width", "space", "albedo-map", "atmosphere", "danjon", "quality",
          "passes", "spectral"},
         {"coppermoon bake 2018-07-27 -o moon_acescg.exr",
          "coppermoon bake 2018-07-27 U1+26min --danjon 2 -o moon.exr -o moon.glb"}},
        {"scene",
         {"at", "output", "field", "width", "height", "texture-width", "danjon", "quality"},
         {"coppermoon scene 2018-07-27 --at Nairobi -o eclipse",
          "coppermoon scene 2018-07-27 --at Nairobi --field 2 --up zenith -o eclipse"}},
        {"shader",
         {"output", "space", "atmosphere", "danjon", "quality", "response", "json"},
         {"coppermoon shader 2018-07-27 -o eclipse",
          "coppermoon shader 2018-07-27 --danjon 1 --space acescg -o eclipse"}},
        {"develop",
         {"output", "time", "iso", "f-number", "camera", "view", "bits"},
         {"coppermoon develop frame.exr --time 2 --iso 800 -o moon.png",
          "coppermoon develop film/frame.0001.exr film/frame.0002.exr --view Filmic -o pictures"}},
        {"ring",
         {"output", "on", "atmosphere", "danjon", "scale"},
         {"coppermoon ring 2018-07-27 -o ring.exr",
          "coppermoon ring 2018-07-27 --on Tycho --danjon 1 -o ring.exr"}},
        {"dome",
         {"at", "output", "width", "moon", "stars", "ground-albedo", "space", "danjon"},
         {"coppermoon dome 2018-07-27 --at Nairobi -o sky.exr",
          "coppermoon dome 2018-07-27 U1+30min --at Nairobi --moon on --ground-albedo 0.2 -o "
          "sky_acescg.exr"}}}},
      {"Films",
       {{"animate",
         {"at", "output", "from", "to", "frames", "make", "time", "movie", "shard", "job"},
         {"coppermoon animate 2018-07-27 --at Nairobi --frames 240 -o film --movie eclipse.mp4",
          "coppermoon animate 2018-07-27 --from U2-10min --to U3+10min --width 1920 --height 1080 "
          "-o film"}}}},
      {"Eclipses and their light",
       {{"almanac",
         {"from", "to", "at", "output", "feature", "shadow-convention", "json"},
         {"coppermoon almanac 2029 --at Honolulu -o 2029.ics",
          "coppermoon almanac --from 2026-01-01 --to 2030-01-01 --feature Tycho"}},
        {"night",
         {"at", "zone", "output", "camera", "focal-length", "iso", "f-number", "danjon-spread",
          "csv", "json"},
         {"coppermoon night 2026-03-03 --at Honolulu",
          "coppermoon night 2026-03-03 --at Honolulu --camera 400mm --iso 800 -o night.ics"}},
        {"explore",
         {"at", "output", "from", "to", "embed", "atmosphere", "albedo-map"},
         {"coppermoon explore 2018-07-27 --at Nairobi -o eclipse.html",
          "coppermoon explore --from 2026-01-01 --to 2030-01-01 -o eclipses"}},
        {"sky",
         {"at", "json"},
         {"coppermoon sky 2018-07-27 --at Nairobi", "coppermoon sky 2018-07-27T20:21:45Z --json"}},
        {"brightness",
         {"at", "from", "to", "step", "output", "danjon", "atmosphere", "quality", "json"},
         {"coppermoon brightness 2018-07-27 U2+10min --danjon 1",
          "coppermoon brightness 2018-07-27 --from P1 --to P4 -o curve.csv -o curve.png"}},
        {"shadow",
         {"output", "axis-distances", "wavelengths", "position-angle", "atmosphere", "danjon",
          "json"},
         {"coppermoon shadow 2018-07-27 -o shadow.svg -o shadow.csv"}},
        {"plan",
         {"at", "width", "height", "texture-width", "quality", "tolerance", "budget", "json"},
         {"coppermoon plan 2018-07-27",
          "coppermoon plan 2018-07-27 --at Nairobi --tolerance 0.2%"}}}},
      {"Photographs",
       {{"compare",
         {"output", "exposure", "coding", "recipe-in", "bins", "json"},
         {"coppermoon compare photo.jpg frame.exr -o sheet.png",
          "coppermoon compare photo.jpg frame.exr --exposure fit --json"}},
        {"fit",
         {"instants", "zone", "at", "output", "magnitudes", "coding", "exposure-error", "json"},
         {"coppermoon fit a.jpg b.jpg --instants from-header --at Nairobi -o light.svg",
          "coppermoon fit --magnitudes night.csv --json"}},
        {"merge",
         {"output"},
         {"coppermoon merge a.exr b.exr c.exr -o merged.exr",
          "coppermoon merge short.exr long.exr -o merged.exr"}}}},
      {"Measurements",
       {{"tradeoff",
         {"output", "quick", "only", "longest", "repeat", "json"},
         {"coppermoon tradeoff --quick -o measured",
          "coppermoon tradeoff --only quadrature -o measured"}}}},
      {"Other programs",
       {{"describe", {"json"}, {"coppermoon describe --json", "coppermoon describe still bake"}},
        {"cache",
         {"list", "clean", "limit"},
         {"coppermoon cache --list", "coppermoon cache --clean --limit 5"}}}}};
  return groups;
}

const Guide& guide_to(std::string_view verb) {
  static const Guide none;
  for (const auto& group : guides())
    for (const auto& guide : group.guides)
      if (guide.verb == verb) return guide;
  return none;
}

}  // namespace coppermoon::verbs
