// SPDX-License-Identifier: MIT
// Every option of every command has an effect by itself, or says of which others it depends. What requests become is
// computed here for each value beside each other, where that takes no time.
#include <memory>
#include "support/testing.h"

#include "almanac/instant.h"
#include "atmosphere/atmosphere.h"
#include "support/testing.h"
#include "uses/dome/dome.h"
#include "uses/light/light_parameters.h"
#include "uses/picture/development.h"
#include "uses/picture/picture_parameters.h"
#include "verbs/command_line.h"
#include "verbs/flags/light_options.h"

namespace coppermoon::verbs::effects_test {

using request::Parameter, request::Parameters, request::Texts;
using Numbers = std::vector<double>;

/// A request's parameters, and what the request becomes.
struct Subject {
  Parameters parameters;
  std::function<Numbers()> outcome;

  /// Nothing where it is refused.
  std::optional<Numbers> result() const {
    try {
      return outcome();
    } catch (const algebra::Error&) {
      return std::nullopt;
    }
  }
  bool take(const std::string& name, const std::string& text) {
    try {
      return parameters.find(name)->take({text}), true;
    } catch (const algebra::Error&) {
      return false;
    }
  }
  void reset() {
    for (auto& each : parameters) each.reset();
  }
  /// Whether it is said of a parameter that its value has no effect.
  bool says(const std::string& name) const {
    return !without_effect(
                parameters, [](const Parameter& each) { return each.name; },
                [&](const Parameter& each) { return each.name == name; })
                .empty();
  }
};

/// Values that differ from the usual one, of few photons and coarse light.
Texts values_of(const Parameter& parameter) {
  static const std::map<std::string, Texts> by_hand{
      {"stratospheric-aerosol", {"extreme", "none", "0.1"}},
      {"region", {"from-latitude=-90,to-latitude=0,cloud-cover=1"}},
      {"at", {"Nairobi"}},
      {"field", {"2"}},
      {"stars", {"off", "4"}},
      {"glow", {"auto", "0.3"}},
      {"sky", {"auto", "off", "12"}},
      {"time", {"2", "follow"}},
      {"response", {"colorimetric", "luminance", "canon-eos-5d-mark-ii"}},
      {"camera", {"refractor"}},
      {"aperture", {"50"}},
      {"noise-seed", {"7"}},
      {"dust-extinction", {"1e-5"}},
      {"dust-bottom-km", {"3", "17"}},
      {"dust-top-km", {"17", "25"}},
      {"tolerance", {"3%"}},
      {"budget", {"2s"}},
      {"leave-out", {"none"}},
      {"bands", {"6"}},
      {"rays", {"20"}},
      {"planes", {"2"}},
      {"place-error", {"0.5"}},
      {"photons", {"300"}},
      {"seed", {"7"}},
      {"step-km", {"60", "90"}},
      {"ring-km", {"400"}},
      {"smoothing-km", {"300"}}};
  if (const auto found = by_hand.find(parameter.name); found != by_hand.end()) return found->second;
  if (!parameter.words.empty()) return parameter.words;
  if (parameter.kind == request::Kind::presence) return {"true"};
  if (!parameter.range) return {};
  const auto [low, high] = *parameter.range;
  if (parameter.kind != request::Kind::number)
    return {request::text_of(int(low)), request::text_of(int(high))};
  return {request::text_of(low), request::text_of(high), request::text_of((low + high) / 3)};
}

/// Checks values of a parameter beside what the subject has been given, up to the first that has an effect: without one
/// it is said, and only then.
///
/// Given     before  what the request becomes without it
/// Returned  whether one of them has an effect
bool expect_said_or_effective(Subject& subject, const std::string& name, const std::string& beside,
                              const std::optional<Numbers>& before,
                              const std::set<std::string>& unsaid = {}) {
  auto& parameter = *subject.parameters.find(name);
  bool effective = false, said = false, refused = false;
  for (const auto& text : values_of(parameter)) {
    if (!subject.take(name, text)) continue;
    const auto after = subject.result();
    const bool changes = after && *after != before;
    if (changes) {
      EXPECT_FALSE(subject.says(name)) << name << " = " << text << beside << ": has an effect";
    }
    effective |= changes;
    said |= subject.says(name);
    refused |= !after;
    parameter.reset();
    if (effective) break;
  }
  if (!effective && !refused && !unsaid.contains(name + beside)) {
    EXPECT_TRUE(said) << name << beside << ": has no effect, and nothing is said";
  }
  return effective;
}

/// Gives the parameter's relations what they need.
void meet_needs(Subject& subject, const Parameter& parameter) {
  for (const auto& relation : parameter.relations) {
    if (!relation.needed) continue;
    for (const auto& condition : relation.conditions) {
      auto* other = subject.parameters.find(condition.name);
      if (other == nullptr) continue;
      const auto values = condition.values.empty() ? values_of(*other) : condition.values;
      subject.take(condition.name, values.front());
      break;
    }
  }
}

/// By itself, and with what it needs.
///
/// Given  others  gives what a value is refused without
void expect_effects(
    Subject& subject, const std::function<void(Subject&)>& others = [](Subject&) {}) {
  const auto usual = subject.result();
  for (const auto& parameter : subject.parameters) {
    const auto name = parameter.name;
    subject.reset();
    if (expect_said_or_effective(subject, name, "", usual)) continue;
    others(subject);
    meet_needs(subject, parameter);
    EXPECT_TRUE(expect_said_or_effective(subject, name, ", with what it needs", subject.result()))
        << name << ": never has an effect";
  }
  subject.reset();
}

/// Whether others depend on a parameter, or it may take all effect from them: numbers that are not 0 do not.
bool may_matter(const Parameter& other, const Parameters& all) {
  if (!is_number(other.kind)) return true;
  return std::ranges::any_of(all, [&](const Parameter& each) {
    return std::ranges::any_of(each.relations, [&](const auto& relation) {
      return std::ranges::count(relation.conditions, other.name, &request::Condition::name) > 0;
    });
  });
}

/// Beside each other.
///
/// Given  unsaid  names and what they stand beside, of which nothing can be said
void expect_effects_beside_others(Subject& subject, const std::set<std::string>& unsaid,
                                  const std::function<void(Subject&)>& begin) {
  for (const auto& other : subject.parameters) {
    if (!may_matter(other, subject.parameters)) continue;
    auto values = values_of(other);
    if (is_number(other.kind)) values.erase(values.begin(), values.end() - 1);
    for (const auto& text : values) {
      subject.reset();
      begin(subject);
      if (!subject.take(other.name, text)) continue;
      const auto before = subject.result();
      if (!before) continue;
      for (const auto& parameter : subject.parameters)
        if (parameter.name != other.name && !parameter.given)
          expect_said_or_effective(subject, parameter.name, " beside " + other.name + " " + text,
                                   before, unsaid);
    }
  }
  subject.reset();
}

constexpr const char* eclipsed = "2018-07-27T20:21:45Z";

void add(const atmosphere::Column& column, const atmosphere::Molecules& molecules, Numbers& all) {
  for (const double nm : {450., 600., 762.}) {
    const auto optics = atmosphere::sea_level_optics(algebra::nanometres(nm), molecules);
    for (const double altitude_m : {1e3, 4e3, 8e3, 12e3, 16e3, 18e3, 22e3, 40e3}) {
      if (altitude_m > top_m(column)) continue;
      all.push_back(extinction_per_m(column, optics, altitude_m));
      all.push_back(refractivity(column, optics, altitude_m));
      all.push_back(limb_filter(column, optics, altitude_m));
    }
  }
}

/// Danjon's scale makes much light to find an air: it is not in it.
struct AirSubject : Subject {
  uses::Air air;

  AirSubject() {
    Parameters all;
    describe(all, air);
    for (auto& parameter : all)
      if (parameter.name != "danjon") parameters.keep(std::move(parameter));
    outcome = [this] {
      const auto made = atmosphere_of(air, algebra::degrees(19), 2018.57);
      Numbers numbers{made.earth.polar_radius_m};
      for (const auto* column : made.columns()) add(*column, made.molecules, numbers);
      return numbers;
    };
  }
};

TEST(Effects, OfTheAirAreThereOrSaid) {
  AirSubject subject;
  expect_effects(subject);
}

TEST(Effects, OfTheAirBesideOtherTermsAreThereOrSaid) {
  AirSubject subject;
  // a region may have dust, or aerosol, of its own
  const std::string region = " beside region from-latitude=-90,to-latitude=0,cloud-cover=1";
  const std::set<std::string> unsaid{"stratospheric-factor beside stratospheric-aerosol none",
                                     "dust-bottom-km" + region, "dust-top-km" + region};
  expect_effects_beside_others(subject, unsaid, [](Subject&) {});
}

struct CameraSubject : Subject {
  uses::Development development;
  texture::Image frame{8, 8, {"R", "G", "B"}};

  CameraSubject() {
    static const std::set<std::string> of_the_picture{"view", "display", "config", "config-space",
                                                      "bits"};
    Parameters all;
    describe(all, development.camera);
    describe(all, development);
    for (auto& parameter : all)
      if (!of_the_picture.contains(parameter.name)) parameters.keep(std::move(parameter));
    for (std::size_t i = 0; i < frame.values.size(); ++i)
      frame.values[i] = 0.01F * static_cast<float>(i % 3 + 1 + (i > 90 ? 200 : 0));
    outcome = [this] {
      constexpr auto space = colour::WorkingSpace::linear_rec709;
      constexpr double arcsec_rad = 4.85e-6;
      const uses::SeenFrame seen{.pixel_rad = arcsec_rad, .sky_cd_m2 = 0.02};
      const auto exposure = exposures_for(development, frame, space, seen).shorter;
      Numbers numbers{exposure.time_s, exposure.f_number, exposure.iso,
                      scale_of(development, exposure)};
      if (spectral_response(development.camera)) numbers.push_back(1);  // of the Moon's light
      const auto camera = camera_of(development.camera, development.f_number);
      if (!camera) return numbers;
      const auto taken = photographed(development.camera, *camera, {frame, space, seen}, exposure);
      for (const auto& pixel : taken.scene_linear.values())
        numbers.insert(numbers.end(), pixel.begin(), pixel.end());
      return numbers;
    };
  }
};

void with_a_camera(Subject& subject) {
  subject.take("camera", "refractor");
  subject.take("time", "2");
}

TEST(Effects, OfTheCameraAreThereOrSaid) {
  CameraSubject subject;
  expect_effects(subject, with_a_camera);
}

TEST(Effects, OfTheCameraBesideItsOtherPartsAreThereOrSaid) {
  CameraSubject subject;
  expect_effects_beside_others(subject, {}, with_a_camera);
}

struct ViewSubject : Subject {
  uses::ViewRequest view;

  ViewSubject() {
    describe(parameters, view);
    outcome = [this] {
      static const auto sky = almanac::sky_at(almanac::instant_from_utc(eclipsed));
      const auto seen = view_of(view, sky);
      const auto& camera = seen.camera;
      Numbers numbers{double(camera.width),
                      double(camera.height),
                      algebra::in_radians(camera.horizontal_field),
                      camera.flattening,
                      camera.up.x,
                      camera.up.y,
                      camera.up.z,
                      camera.position.x,
                      double(seen.stars.shown),
                      seen.stars.faintest.value_or(99),
                      seen.sky_cd_m2.value_or(seen.observer ? -1 : 0),
                      seen.air.ozone_du,
                      seen.air.aerosol_optical_depth};
      if (const auto& line = seen.sightline)
        for (const double nm : {450., 650.})
          numbers.push_back(
              atmosphere::transmittance_above(line->air, line->altitude, algebra::nanometres(nm)));
      return numbers;
    };
  }
};

TEST(Effects, OfTheViewAreThereOrSaid) {
  ViewSubject subject;
  expect_effects(subject);
}

TEST(Effects, OfTheViewBesideItsOtherPartsAreThereOrSaid) {
  ViewSubject subject;
  expect_effects_beside_others(subject, {}, [](Subject& seen) { seen.take("at", "Nairobi"); });
}

/// Light of few wavelengths and photons in pure air.
struct LightSubject : Subject {
  LightOptions options;

  LightSubject() {
    auto& request = options.request;
    request.air.atmosphere = "molecular";
    request.air.earth = uses::EarthFigure::sphere;
    uses::describe_sunlight(parameters, request);
    describe(parameters, options.effort);
    uses::describe_knobs(parameters, request.by_hand);
    uses::describe_solver(parameters, request);
    outcome = [this] {
      static const auto sky = almanac::sky_at(almanac::instant_from_utc(eclipsed));
      auto asked = light_request(options);
      if (options.effort.quality == "paper") asked.photons = options.request.photons.value_or(100);
      asked.by_hand.bands = options.request.by_hand.bands.value_or(3);
      const bool photons = wants_photons(asked);
      if (photons) asked.photons = asked.photons.value_or(200);
      const auto light = light_on_the_moon(asked, sky, {.error_told = false});
      const auto& work = light.plan.work;
      Numbers numbers{double(work.bands), double(work.rays), double(work.planes),
                      work.place_error,   work.photons,      double(work.solver)};
      if (!photons) numbers.push_back(work.sun_terms);
      for (const auto& ratio : light.refracted->ratio)
        numbers.insert(numbers.end(), ratio.values().begin(), ratio.values().end());
      return numbers;
    };
  }
};

TEST(Effects, OfLightAreThereOrSaid) {
  LightSubject subject;
  expect_effects(subject);
}

/// Commands with their parameters.
struct AllCommands : Program {
  AllCommands() { add_verbs(*this); }
};

/// Options that commands have of their own, or whose effect takes long to show. Each has one whatever the others are:
/// somebody looked.
const std::set<std::string, std::less<>>& effective_by_themselves() {
  static const std::set<std::string, std::less<>> all{
      // what is asked, when and where
      "instant", "eclipse", "calendar", "year", "from", "to", "step", "at", "focal-length", "zone",
      "on", "feature", "instants", "frame", "photo", "render", "photos", "photographs",
      "magnitudes", "recipe-in", "commands", "shadow-convention", "brightness", "moon-distance-km",
      "sun-distance-km", "wavelengths", "axis-distances", "position-angle", "danjon-spread",
      "unknowns", "despite-misfit", "only", "longest", "repeat", "quick",
      // what is written, and how; several are refused where they contradict others
      "output", "json", "csv", "recipe", "raw", "photograph", "contact-sheet", "curve", "movie",
      "hdr", "composite", "stage", "cache", "embed", "for", "list", "clean", "limit", "folder",
      "job", "dry-run", "replace", "shard", "keep", "add", "stars", "sky",
      // of a film: a run may make what a later one needs, and its folder keeps all of them
      "frames", "fps", "start-frame", "time-scale", "duration", "moments", "make", "range", "mount",
      "aim", "scene", "bracket", "caption", "space", "type", "spectral", "passes",
      // of textures, domes, strips and measurements
      "albedo-map", "photometry", "ground", "texture-width", "unshadowed", "width", "moon",
      "ground-albedo", "scale", "exposure", "bins", "coding", "response", "time", "danjon",
      // of pictures
      "view", "display", "config", "config-space", "bits"};
  return all;
}

TEST(Effects, AreThereOrSaidOfEveryOptionOfEveryCommand) {
  std::map<std::string, std::set<std::string>> shown;  // meanings by name
  const AirSubject air;
  const CameraSubject camera;
  const ViewSubject view;
  const LightSubject light;
  for (const auto* parameters :
       {&air.parameters, &camera.parameters, &view.parameters, &light.parameters})
    for (const auto& each : *parameters) shown[each.name].insert(each.meaning);
  AllCommands program;
  for (const auto& verb : program.verbs)
    for (const auto& option : verb.parameters) {
      const bool known = shown[option.name].contains(option.meaning) || !option.relations.empty() ||
                         effective_by_themselves().contains(option.name);
      EXPECT_TRUE(known) << verb.name << " --" << option.name
                         << ": has it an effect beside all others? Where not, only_with or "
                            "not_beside says so";
    }
}

TEST(Effects, DependOnOptionsThatThereAreAndOnValuesThatTheyTake) {
  AllCommands program;
  for (const auto& verb : program.verbs)
    for (const auto& option : verb.parameters)
      for (const auto& relation : option.relations)
        for (const auto& condition : relation.conditions) {
          bool found = false;
          for (const auto& other : program.verbs)
            found |= other.parameters.find(condition.name) != nullptr;
          EXPECT_TRUE(found) << option.name << " depends on " << condition.name;
          const auto* other = verb.parameters.find(condition.name);
          if (other == nullptr || other->words.empty()) continue;
          for (const auto& value : condition.values)
            EXPECT_TRUE(std::ranges::count(other->words, value))
                << option.name << " depends on " << condition.name << " " << value;
        }
}

TEST(Ranges, OfNumbersAreToldOrThereIsNone) {
  /// Seeds: any number is one.
  static const std::set<std::string> without_range{"seed", "noise-seed"};
  AllCommands program;
  for (auto& verb : program.verbs)
    for (auto& option : verb.parameters) {
      const bool number = is_number(option.kind) && option.words.empty();
      EXPECT_EQ(number && !without_range.contains(option.name), option.range.has_value())
          << verb.name << " --" << option.name;
      if (!number || !option.range) continue;
      for (const auto* text : {"-1e300", "nan", "inf", "1e300"})
        EXPECT_THROW(option.take({text}), algebra::Error) << option.name << " = " << text;
      EXPECT_FALSE(option.given) << option.name;
    }
}

TEST(Ranges, OfNumbersAmongWordsAreKeptWhenTheyAreTaken) {
  AllCommands program;
  auto& all = find_verb(program, "still")->parameters;
  for (const char* name : {"glow", "sky", "stars", "field", "time", "stratospheric-aerosol"})
    for (const char* text : {"nan", "-7", "1e9", "inf"})
      EXPECT_THROW(all.find(name)->take({text}), algebra::Error) << name << " = " << text;
}

}  // namespace coppermoon::verbs::effects_test
