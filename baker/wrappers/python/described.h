// SPDX-License-Identifier: MIT
// Python names, types, values and docstrings of parameters. The Python module and its type stub are made from these.
#pragma once

#include <string>

#include "request/parameter.h"
#include "result/fields.h"
#include "uses/dome/dome.h"
#include "uses/light/moonlight.h"
#include "uses/picture/baked_moon.h"
#include "uses/picture/view.h"

namespace coppermoon::python {

/// The parameters of the Python classes Air, Region and Light. Those of Air and Region are described in `uses`. Light
/// also has a tolerance and a budget.
request::Parameters parameters_of(uses::Air& air);
request::Parameters parameters_of(uses::AirRegion& region);
request::Parameters parameters_of(uses::LightRequest& light);

/// Settings that the keyword arguments of Python's `bake` change, with their default values.
struct TextureKeywords {
  uses::MoonRequest moon{.texture_width = 4096};
  uses::ViewRequest view{};
  uses::TextureContent content{.space = colour::WorkingSpace::linear_rec709,
                               .type = texture::ExrType::floating};
};

/// Settings that the keyword arguments of Python's `dome` change, with their default values.
struct DomeKeywords {
  TextureKeywords moon{.moon = {}};
  uses::DomeRequest dome{.content = {.space = colour::WorkingSpace::linear_rec709,
                                     .type = texture::ExrType::floating}};
};

/// Keyword arguments of `bake`, `brightness`, `dome` and `fit`, except the objects air, light and place.
request::Parameters bake_keywords(TextureKeywords& keywords);
request::Parameters brightness_keywords(TextureKeywords& keywords);
request::Parameters dome_keywords(DomeKeywords& keywords);
request::Parameters fit_keywords(TextureKeywords& keywords);

/// A parameter's name in Python: "ozone-du" becomes "ozone_du".
std::string name_of(const request::Parameter& parameter);

/// Whether a parameter may be None, which means that it has no value.
bool may_be_none(const request::Parameter& parameter);

/// A parameter's type annotation in the stub, such as "float | None".
std::string type_of(const request::Parameter& parameter);

/// A parameter's value as a Python literal: "None", "True", "280.0", "'standard'", "[Region(cloud_cover=1.0)]".
std::string literal_of(const request::Parameter& parameter);

/// Text that explains a parameter, in which other parameters have their Python names.
std::string meaning_of(const request::Parameter& parameter);

/// All parameters with their values, as in a signature: "ozone_du=None, cloud_cover=None".
std::string signature_of(const request::Parameters& parameters);

/// Text with one line "name: meaning" for each parameter.
std::string lines_of(const request::Parameters& parameters);

/// The type annotation of a result's property in the stub, such as "float | None".
std::string type_of(const result::Field& field);

/// Text with one line "key: meaning [unit]" for each field.
std::string lines_of(const result::Fields& fields);

/// A request as text, such as "Air(ozone_du=250.0)". Only parameters that differ from the defaults are shown.
template <class Request>
std::string text_of(const std::string& type, Request request);

}  // namespace coppermoon::python
