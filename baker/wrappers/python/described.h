// SPDX-License-Identifier: MIT
// Parameters of requests as Python shows them: names, types, values, docstrings. The module and its stub are made from
// them.
#pragma once

#include <string>

#include "request/parameter.h"
#include "result/fields.h"
#include "uses/dome/dome.h"
#include "uses/light/moonlight.h"
#include "uses/picture/baked_moon.h"
#include "uses/picture/view.h"

namespace coppermoon::python {

/// Parameters of a class: Air and Region have those of `uses`, Light also its tolerance and budget as numbers.
request::Parameters parameters_of(uses::Air& air);
request::Parameters parameters_of(uses::AirRegion& region);
request::Parameters parameters_of(uses::LightRequest& light);

/// Requests behind the keywords of `bake`, with its defaults.
struct TextureKeywords {
  uses::MoonRequest moon{.texture_width = 4096};
  uses::ViewRequest view{};
  uses::TextureContent content{.space = colour::WorkingSpace::linear_rec709,
                               .type = texture::ExrType::floating};
};

/// Requests behind the keywords of `dome`.
struct DomeKeywords {
  TextureKeywords moon{.moon = {}};
  uses::DomeRequest dome{.content = {.space = colour::WorkingSpace::linear_rec709,
                                     .type = texture::ExrType::floating}};
};

/// Keywords of `bake`, of `brightness`, of `dome` and of `fit`, without those that Python reads as objects: air, light, place.
request::Parameters bake_keywords(TextureKeywords& keywords);
request::Parameters brightness_keywords(TextureKeywords& keywords);
request::Parameters dome_keywords(DomeKeywords& keywords);
request::Parameters fit_keywords(TextureKeywords& keywords);

/// Name in Python: "ozone-du" → "ozone_du".
std::string name_of(const request::Parameter& parameter);

/// Whether None stands for no value.
bool may_be_none(const request::Parameter& parameter);

/// Annotation in the stub: "float | None".
std::string type_of(const request::Parameter& parameter);

/// Value as a Python literal: "None", "True", "280.0", "'standard'", "[Region(cloud_cover=1.0)]".
std::string literal_of(const request::Parameter& parameter);

/// Meaning, with the parameters that it mentions by their names in Python.
std::string meaning_of(const request::Parameter& parameter);

/// "ozone_du=None, cloud_cover=None": all parameters and their values.
std::string signature_of(const request::Parameters& parameters);

/// A line "name: meaning" for each parameter.
std::string lines_of(const request::Parameters& parameters);

/// Annotation of a result's property in the stub: "float | None".
std::string type_of(const result::Field& field);

/// A line "key: meaning [unit]" for each field.
std::string lines_of(const result::Fields& fields);

/// "Air(ozone_du=250.0)": the parameters that differ from those of a new request.
template <class Request>
std::string text_of(const std::string& type, Request request);

}  // namespace coppermoon::python
