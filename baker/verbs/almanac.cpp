// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "algebra/error.h"
#include "almanac/instant.h"
#include "eclipse/contacts.h"
#include "verbs/recipe.h"
#include "verbs/verbs.h"

namespace coppermoon::verbs {
namespace {

struct Options {
  std::string from, to, convention = "danjon";
  bool json = false;
};

const char* name(eclipse::EclipseType type) {
  switch (type) {
    case eclipse::EclipseType::penumbral:
      return "penumbral";
    case eclipse::EclipseType::partial:
      return "partial";
    default:
      return "total";
  }
}

eclipse::ShadowConvention convention_from(const std::string& name) {
  if (name == "chauvenet") return eclipse::ShadowConvention::chauvenet;
  if (name == "herald-sinnott") return eclipse::ShadowConvention::herald_sinnott;
  return eclipse::ShadowConvention::danjon;
}

using Contact = std::pair<const char*, std::optional<almanac::Instant>>;

std::vector<Contact> contacts_of(const eclipse::Eclipse& e) {
  const auto& c = e.contacts;
  return {{"P1", c.P1}, {"U1", c.U1}, {"U2", c.U2}, {"U3", c.U3}, {"U4", c.U4}, {"P4", c.P4}};
}

nlohmann::ordered_json as_json(const eclipse::Eclipse& e) {
  nlohmann::ordered_json contacts = nlohmann::ordered_json::object();
  for (const auto& [key, when] : contacts_of(e))
    if (when) contacts[key] = almanac::utc_text(*when);
  return {{"greatest", almanac::utc_text(e.greatest)},
          {"type", name(e.type)},
          {"gamma", e.gamma},
          {"umbral_magnitude", e.umbral_magnitude},
          {"penumbral_magnitude", e.penumbral_magnitude},
          {"contacts", contacts}};
}

std::string time_of_day(const almanac::Instant& when) {
  const std::string text = almanac::utc_text(when);
  return text.substr(text.find('T') + 1, 8);
}

void print(const std::vector<eclipse::Eclipse>& eclipses) {
  fmt::print("{:<21}{:<10}{:>8}{:>9}{:>9}", "greatest (UTC)", "type", "gamma", "umbral", "penumb.");
  for (const char* key : {"P1", "U1", "U2", "U3", "U4", "P4"}) fmt::print("  {:<8}", key);
  fmt::print("\n");
  for (const auto& e : eclipses) {
    fmt::print("{:<21}{:<10}{:>8.4f}{:>9.4f}{:>9.4f}", almanac::utc_text(e.greatest), name(e.type),
               e.gamma, e.umbral_magnitude, e.penumbral_magnitude);
    for (const auto& [key, when] : contacts_of(e))
      fmt::print("  {:<8}", when ? time_of_day(*when) : "-");
    fmt::print("\n");
  }
}

void run(const Options& options) {
  const auto from = almanac::instant_from_utc(options.from),
             to = almanac::instant_from_utc(options.to);
  if (almanac::seconds_between(from, to) < 0)
    throw algebra::Error(fmt::format("--to = {}, allowed {} or later", options.to, options.from));
  const auto eclipses = eclipse::eclipses_between(from, to, convention_from(options.convention));
  if (!options.json) return print(eclipses);
  auto list = nlohmann::ordered_json::array();
  for (const auto& e : eclipses) list.push_back(as_json(e));
  fmt::print("{}\n", list.dump(2));
}

}  // namespace

void add_almanac(CLI::App& program) {
  auto* verb = program.add_subcommand("almanac", "Eclipses: type, gamma, magnitudes, contacts");
  const auto options = std::make_shared<Options>();
  verb->add_option("--from", options->from, "ISO 8601 UTC, as 2008-01-01")->required();
  verb->add_option("--to", options->to, "ISO 8601 UTC")->required();
  verb->add_option("--shadow-convention", options->convention,
                   "how the air enlarges the shadow: danjon, chauvenet or herald-sinnott")
      ->check(CLI::IsMember({"danjon", "chauvenet", "herald-sinnott"}));
  verb->add_flag("--json", options->json, "one JSON document on stdout");
  add_recipe_option(*verb);
  verb->callback([options] { run(*options); });
}

}  // namespace coppermoon::verbs
