// SPDX-License-Identifier: MIT
// Writes the package's type stub. In its template, a line @NAME@ stands for the parameters of a class or function.
#include <fmt/format.h>

#include <iostream>
#include <map>
#include <string>

#include "eclipse/contacts.h"
#include "uses/fit/fit_results.h"
#include "uses/light/shadow_profile.h"
#include "uses/picture/brightness.h"
#include "wrappers/python/described.h"
#include "wrappers/python/own_results.h"

namespace coppermoon::python {
namespace {

/// Type in the stub for an argument. Numbers may also be NumPy's, and files may be path objects.
std::string taken_type(const request::Parameter& parameter) {
  auto type = type_of(parameter);
  const auto end = type.find(" |");
  const auto own = type.substr(0, end), none = end == type.npos ? "" : type.substr(end);
  if (parameter.kind == request::Kind::file_read) return "File" + none;
  if (own == "float") return "Number" + none;
  if (own == "int") return "Whole" + none;
  return own == "bool" ? "Switch" + none : type;
}

std::string keywords(const request::Parameters& parameters, const std::string& indent) {
  std::string text;
  for (const auto& parameter : parameters)
    text += fmt::format("{}{}: {} = {},\n", indent, name_of(parameter), taken_type(parameter),
                        literal_of(parameter));
  return text;
}

template <class Request>
std::string members() {
  Request request;
  const auto parameters = parameters_of(request);
  auto text = fmt::format("    def __init__(\n        self,\n        *,\n{}    ) -> None: ...\n",
                          keywords(parameters, "        "));
  for (const auto& parameter : parameters)
    text += fmt::format("    @property\n    def {}(self) -> {}: ...\n", name_of(parameter),
                        type_of(parameter));
  return text;
}

template <result::Described Result>
std::string properties() {
  std::string text;
  for (const auto& field : result::fields_of<Result>().all)
    text += fmt::format("    @property\n    def {}(self) -> {}: ...\n", field.key, type_of(field));
  return text;
}

std::map<std::string, std::string> all_parts() {
  TextureKeywords texture, brightness, fit;
  DomeKeywords dome;
  const std::string indent(4, ' ');
  return {{"    @Air@", members<uses::Air>()},
          {"    @Region@", members<uses::AirRegion>()},
          {"    @Light@", members<uses::LightRequest>()},
          {"    @Eclipse@", properties<eclipse::Eclipse>()},
          {"    @Sky@", properties<SkyOfArrays>()},
          {"    @ShadowProfile@", properties<uses::ShadowProfile>()},
          {"    @Moonlight@", properties<LitSphere>()},
          {"    @Brightness@", properties<uses::MoonBrightness>()},
          {"    @BrightnessSeen@", properties<uses::BrightnessSeen>()},
          {"    @Estimate@", properties<uses::Estimate>()},
          {"    @ClippedAt@", properties<uses::ClippedAt>()},
          {"    @PhotographRead@", properties<uses::ReadPhotograph>()},
          {"    @Clock@", properties<uses::ClockError>()},
          {"    @Misfit@", properties<uses::Misfit>()},
          {"    @Night@", properties<uses::FittedNight>()},
          {"    @Suspicion@", properties<uses::Suspicion>()},
          {"    @Fit@", properties<uses::FitReport>()},
          {"    @bake@", keywords(bake_keywords(texture), indent)},
          {"    @brightness@", keywords(brightness_keywords(brightness), indent)},
          {"    @dome@", keywords(dome_keywords(dome), indent)},
          {"    @fit@", keywords(fit_keywords(fit), indent)}};
}

}  // namespace
}  // namespace coppermoon::python

int main() {
  const auto parts = coppermoon::python::all_parts();
  for (std::string line; std::getline(std::cin, line);) {
    const auto part = parts.find(line);
    std::cout << (part == parts.end() ? line + "\n" : part->second);
  }
}
