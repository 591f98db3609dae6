// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <memory>

#include "algebra/error.h"
#include "almanac/gazetteer.h"
#include "files/name_to_share.h"
#include "files/own_file.h"
#include "files/whole_file.h"
#include "result/as_json.h"
#include "uses/explore/exploration.h"
#include "uses/light/light_parameters.h"
#include "uses/picture/local_time.h"
#include "uses/picture/place_text.h"
#include "verbs/command_line.h"
#include "verbs/flags/film_options.h"
#include "verbs/flags/known_words.h"
#include "verbs/flags/moments.h"
#include "verbs/flags/moon_options.h"
#include "verbs/reports/one_line.h"
#include "verbs/reports/progress_bar.h"

namespace coppermoon::verbs {
namespace of_explore {
namespace {

namespace fs = std::filesystem;

struct Options {
  FilmOptions film;  ///< only its eclipse and calendar are used
  std::string from, to, output;
  uses::ExploreRequest request;
  bool embed = false, json = false, csv = false;

  bool tells() const { return !json && !csv; }
};

void require_sound(const Options& options) {
  const bool many = !options.from.empty() || !options.to.empty();
  if (many == !options.film.eclipse.empty())
    throw WrongUsage("allowed is the day of an eclipse, as 2018-07-27, or --from and --to");
  if (many && (options.from.empty() || options.to.empty()))
    throw WrongUsage("--from and --to: one is missing");
  if (many && options.embed) throw WrongUsage("--embed: goes with one eclipse");
  const fs::path file = options.output;
  if (!many && file.extension() != ".html")
    throw algebra::Error(fmt::format("{}: a page ends in .html", one_line(options.output)));
  if (!many) return files::require_place_for(file);
  if (fs::exists(file) && !fs::is_directory(file))
    throw algebra::Error(fmt::format("{}: is no directory", one_line(options.output)));
}

/// A word as it is typed in a shell, in quotes if it needs them.
std::string shell_word(const std::string& word) {
  const bool plain = word.find_first_not_of(
                         "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                         "0123456789.,:+-/_=") == std::string::npos;
  return plain ? word : in_single_quotes(word);
}

/// The flags given by the user for the air and the map, as text for the command lines that the page shows.
std::string options_shown(const Verb& verb) {
  std::string flags;
  for (const auto& parameter : verb.parameters) {
    const bool shown = parameter.table == "atmosphere" || parameter.name.starts_with("albedo-") ||
                       parameter.name == "photometry" || parameter.name == "ground";
    if (!shown || !parameter.given) continue;
    for (const auto& text : parameter.texts())
      flags += fmt::format(
          "{}--{} {}", flags.empty() ? "" : " ", parameter.name,
          shell_word(parameter.kind == request::Kind::file_read ? files::name_to_share(text)
                                                                : text));
  }
  return flags;
}

std::string stamped(const std::string& page) { return files::stamped(page, "<!--", " -->"); }

struct Page {
  std::string file, title;
  std::size_t bytes = 0;
};

template <class Field>
void describe(Field&& is, const Page& page) {
  is.a("Page", "A page that was written.");
  is("file", page.file, "its file");
  is("title", page.title, "its title");
  is("bytes", page.bytes, algebra::unit::bytes, "its size");
}

/// A page that lists other pages, one for each eclipse.
struct Pages {
  std::string file;
  std::vector<Page> pages;
};

template <class Field>
void describe(Field&& is, const Pages& all) {
  is.a("Pages", "A list of pages, with --from and --to.");
  is("file", all.file, "file of the list");
  is("pages", all.pages, "the pages");
}

Page write_page(const eclipse::Eclipse& eclipse, const Options& options, const fs::path& file) {
  const auto exploration = [&] {
    ProgressBar bar("page");
    return uses::exploration_of(eclipse, options.request, bar.progress());
  }();
  const auto extent = options.embed ? uses::PageExtent::fragment : uses::PageExtent::whole;
  auto page = uses::page_of(exploration, extent);
  if (extent == uses::PageExtent::whole) page = stamped(page);
  files::write_whole(file, page);
  if (options.tells())
    fmt::print("{}: {}, {:.1f} MB\n", one_line(file.string()), exploration.title,
               static_cast<double>(page.size()) / 1e6);
  return {file.string(), exploration.title, page.size()};
}

std::string page_name(const eclipse::Eclipse& eclipse) {
  const auto when = almanac::utc_text(eclipse.greatest);
  return when.substr(0, when.find('T')) + ".html";
}

Pages write_calendar(const Options& options) {
  const auto from = almanac::instant_from_utc(options.from, options.film.calendar),
             to = almanac::instant_from_utc(options.to, options.film.calendar);
  const auto eclipses = eclipse::eclipses_between(from, to, eclipse::ShadowConvention::danjon);
  if (eclipses.empty())
    throw algebra::Error(
        fmt::format("from {} to {}: no eclipse of the Moon", options.from, options.to));
  const fs::path folder = options.output, list = folder / "index.html";
  std::vector<std::string> pages;
  for (const auto& eclipse : eclipses) pages.push_back(page_name(eclipse));
  files::require_stamped(list);
  for (const auto& page : pages) files::require_stamped(folder / page);
  fs::create_directories(folder);
  Pages written{list.string(), {}};
  for (std::size_t i = 0; i < eclipses.size(); ++i)
    written.pages.push_back(write_page(eclipses[i], options, folder / pages[i]));
  files::write_whole(list, stamped(uses::calendar_page(eclipses, pages)));
  if (options.tells()) fmt::print("{}: {} eclipses\n", one_line(list.string()), eclipses.size());
  return written;
}

void run(const Verb& verb, Options options) {
  require_sound(options);
  auto& request = options.request;
  request.options = options_shown(verb);
  if (request.observer) {
    const auto named = almanac::city_named(request.place);
    request.time_zone = named ? named->time_zone : uses::time_zone_of(*request.observer);
    if (!named) say_whose_clocks(*request.observer);
    request.place = named ? named->name : "";
  }
  const bool many = !options.from.empty();
  const auto written =
      many ? write_calendar(options)
           : Pages{
                 {},
                 {write_page(eclipse_of(options.film, request.observer), options, options.output)}};
  if (options.json)
    fmt::print("{}\n",
               (many ? result::as_json(written) : result::as_json(written.pages[0])).dump(2));
  else if (options.csv)
    fmt::print("{}", result::as_csv(written.pages));
}

}  // namespace
}  // namespace of_explore

void add_explore(Program& program) {
  using namespace of_explore;
  auto& verb = add_verb(program, "explore",
                        "makes an eclipse a page for any browser, in which time, place, exposure "
                        "and air are changed by hand");
  const auto options = std::make_shared<Options>();
  add_flag(verb, "eclipse,--eclipse", options->film.eclipse, "day of the eclipse, as 2018-07-27");
  add_calendar_option(verb, options->film.calendar);
  add_flag(verb, "--from", options->from,
           "first day of a calendar: a page for every eclipse, in a folder");
  add_flag(verb, "--to", options->to, "last day of the calendar");
  add_parsed(
      verb, "--at",
      [options](const std::string& text) {
        options->request.observer = uses::observer_from(text);
        options->request.place = text;
      },
      "place of the observer when the page opens: a city, as Nairobi, or LAT,LON[,ELEV] [degrees "
      "north and east, metres]; default: the Earth's centre");
  add_flag(verb, "-o,--output", options->output,
           "page, .html; with --from and --to a folder of them, with a list in index.html")
      .writes_file()
      .required();
  add_switch(verb, "--embed", options->embed, "writes the part of a page that stands in your own");
  add_json_switch(verb, options->json, {result::fields_of<Page>, result::fields_of<Pages>});
  add_run_switch(verb, "--csv", options->csv, "prints the pages as CSV").not_beside({{"json"}});
  add_map_options(verb, options->request.moon);
  add_described(verb, options->request.moon.light.air);
  on_run(verb, [&verb, options] { run(verb, *options); });
}

}  // namespace coppermoon::verbs
