// SPDX-License-Identifier: MIT
#include "uses/light/moonlight.h"

#include "wrappers/python/fields.h"
#include "wrappers/python/nouns.h"

namespace coppermoon::python {
namespace {

using uses::LightRequest;

std::vector<Field<LightRequest>> light_fields() {
  const auto of = [](const char* name, auto LightRequest::*member, const char* text) {
    return field<LightRequest>(
        name, [member](LightRequest & all) -> auto& { return all.*member; }, text);
  };
  const auto by_hand = [](const char* name, auto plan::ByHand::*member, const char* text) {
    return field<LightRequest>(
        name, [member](LightRequest & all) -> auto& { return all.by_hand.*member; }, text);
  };
  const auto wish = [](const char* name, auto plan::Wish::*member, const char* text) {
    return field<LightRequest>(
        name, [member](LightRequest & all) -> auto& { return all.wish.*member; }, text);
  };
  return {
      wish("tolerance", &plan::Wish::tolerance,
           "largest relative error of luminance on the disc, 1e-4 to 0.5"),
      wish("budget_s", &plan::Wish::budget_s, "time that the light may take [s], 1e-3 or more"),
      by_hand("bands", &plan::ByHand::bands, "number of wavelengths, 1 to 400"),
      by_hand("rays", &plan::ByHand::rays,
              "number of rays between the ground and the top of the air, 2 to 1e7"),
      by_hand("sun_terms", &plan::ByHand::sun_terms,
              "number of terms of the Sun's limb darkening, 1 to 6"),
      by_hand("planes", &plan::ByHand::planes, "number of planes across the Moon's depth, 1 to 9"),
      by_hand("place_error", &plan::ByHand::place_error,
              "error of light between the places where it is computed, 1e-5 to 1"),
      of("limb_darkening", &LightRequest::limb_darkening, "limb darkening of the Sun"),
      of("scattered_light", &LightRequest::scattered_light,
         "sunlight that the air scatters into the shadow: 'auto' (where it counts), 'on' or 'off'"),
      of("starlight", &LightRequest::starlight, "light of the stars on the Moon"),
      of("solver", &LightRequest::solver,
         "'quadrature', 'photons', or 'auto': the quicker; photons where their number is given"),
      of("photons", &LightRequest::photons,
         "number of photons, 1 to 1e12; None: as many as the tolerance needs"),
      of("trace", &LightRequest::trace,
         "tracing of photons: 'table', 'marched' or 'each' (step by step, as in the paper)"),
      of("precision", &LightRequest::precision, "of photons that are marched: 'full' or 'single'"),
      of("step_km", &LightRequest::step_km, "length of a step of a photon's path [km]"),
      of("ring_km", &LightRequest::ring_km, "width of the rings that gather photons [km]"),
      of("smoothing_km", &LightRequest::smoothing_km,
         "standard deviation of the Gaussian that smooths photons [km], 0 to 2000"),
      of("seed", &LightRequest::seed, "seed of the photons")};
}

}  // namespace

void add_light(py::module_& package) {
  class_of(package, "Light", light_fields(),
           "How light is computed, as the command's options of these names have it. What is None "
           "is chosen so that the tolerance is met.\n\n"
           ">>> coppermoon.Light(tolerance=0.05)\n"
           "Light(tolerance=0.05)");
}

}  // namespace coppermoon::python
