// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "algebra/progress.h"
#include "almanac/observer.h"
#include "eclipse/contacts.h"
#include "uses/explore/page_arrays.h"
#include "uses/picture/moon.h"

namespace coppermoon::uses {

struct ExploreRequest {
  MoonRequest moon{};  ///< only the map, the photometry, the air and the Sun are used
  std::optional<almanac::Observer> observer{};  ///< initial observer; if absent, the Earth's centre
  std::string place{}, time_zone{};             ///< observer's place name and time zone
  std::string options{};                        ///< appended to every command that the page shows
};

/// Data from which a page can compute the light on the Moon at any moment of one eclipse.
struct Exploration {
  std::string title;  ///< such as "Total eclipse of the Moon, 2018-07-27"
  nlohmann::ordered_json facts;
  PageArrays arrays;
};

/// Collects the data for a page: limb rays, motions, albedo, colour responses, views, cities and lunar features. The
/// page itself computes the refracted light from the rays, as shadow::by_quadrature does.
///
/// Throws  Error  if normal_albedo or atmosphere_of does
Exploration exploration_of(const eclipse::Eclipse& eclipse, const ExploreRequest& request,
                           const algebra::Progress& progress = {});

/// Whether to write a whole HTML page, or a fragment to embed in another page.
enum class PageExtent { whole, fragment };

/// The interactive page as self-contained HTML, which needs no other files and no network.
std::string page_of(const Exploration& exploration, PageExtent extent = PageExtent::whole);

/// HTML page that lists eclipses and links to their interactive pages.
///
/// Given  pages  file names of the pages, one for each eclipse
std::string calendar_page(const std::vector<eclipse::Eclipse>& eclipses,
                          const std::vector<std::string>& pages);

}  // namespace coppermoon::uses
