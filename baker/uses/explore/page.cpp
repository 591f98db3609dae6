// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <map>

#include "almanac/calendar.h"
#include "explore/tables.h"
#include "uses/explore/exploration.h"

namespace coppermoon::uses {
namespace {

/// Replaces each character of a text that has an entry in `escapes` with that entry.
std::string escaped(const std::string& text, const std::map<char, const char*>& escapes) {
  std::string safe;
  for (const char letter : text) {
    const auto found = escapes.find(letter);
    safe += found == escapes.end() ? std::string(1, letter) : found->second;
  }
  return safe;
}

std::string in_html(const std::string& text) {
  return escaped(text, {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}});
}

/// HTML for the interactive part of the page, which shows a message until the script starts. In embedded JSON, "<" is
/// escaped so that it can neither end the script element nor begin a comment.
std::string fragment_of(const Exploration& exploration, PageExtent extent) {
  auto facts = exploration.facts;
  facts["arrays"] = exploration.arrays.index();
  return fmt::format(
      "<div class=\"coppermoon\"{} style=\"height: 100%\">\n"
      "<div class=\"shown\" style=\"height: 100%\"><p>{}, drawn by this page's script. It has not "
      "begun: it "
      "is still loading, or the policy of this site forbids it.</p>\n"
      "<noscript><p>Scripts are switched off in this browser.</p></noscript></div>\n"
      "<script type=\"application/json\" class=\"facts\">{}</script>\n"
      "<script type=\"text/plain\" class=\"arrays\">{}</script>\n"
      "<script>{}</script>\n"
      "</div>\n",
      extent == PageExtent::fragment ? " data-embedded" : "", in_html(exploration.title),
      escaped(facts.dump(), {{'<', "\\u003c"}}), exploration.arrays.text(),
      explore::tables::page());
}

std::string whole_page(const std::string& title, const std::string& style,
                       const std::string& body) {
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n{}</body>\n</html>\n",
      in_html(title), style, body);
}

}  // namespace

std::string page_of(const Exploration& exploration, PageExtent extent) {
  auto fragment = fragment_of(exploration, extent);
  if (extent == PageExtent::fragment) return fragment;
  return whole_page(exploration.title,
                    "html, body { height: 100%; margin: 0; background: #000; color: #ddd; }",
                    fragment);
}

std::string calendar_page(const std::vector<eclipse::Eclipse>& eclipses,
                          const std::vector<std::string>& pages) {
  std::string rows;
  for (std::size_t i = 0; i < eclipses.size(); ++i) {
    const auto when = almanac::utc_text(almanac::to_the_minute(eclipses[i].greatest));
    rows += fmt::format(
        "<tr><td><a href=\"{}\">{}</a></td><td>{}</td><td>{}</td><td>{:.2f}</td></tr>\n", pages[i],
        when.substr(0, when.find('T')), when.substr(when.find('T') + 1, 5), name(eclipses[i].type),
        eclipses[i].umbral_magnitude);
  }
  return whole_page(
      "Eclipses of the Moon",
      "body { background: #0c0c0c; color: #ddd; font: 16px/1.5 system-ui, sans-serif; margin: "
      "2rem; } "
      "a { color: #ffb070; } th, td { text-align: left; padding: .2rem 1.5rem .2rem 0; }",
      "<h1>Eclipses of the Moon</h1>\n<table>\n<tr><th>day</th><th>greatest, UTC</th><th>kind</th>"
      "<th>umbral magnitude</th></tr>\n" +
          rows + "</table>\n");
}

}  // namespace coppermoon::uses
