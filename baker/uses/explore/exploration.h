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

/// Request for the interactive page of one eclipse.
struct ExploreRequest {
  MoonRequest moon{};  ///< map and photometry; of its light, only air and Sun are used
  std::optional<almanac::Observer> observer{};  ///< when the page opens; absent: the Earth's centre
  std::string place{}, time_zone{};             ///< the observer's
  std::string options{};                        ///< appended to each command that the page shows
};

/// Numbers with which a page can light the Moon at any moment of one eclipse.
struct Exploration {
  std::string title;  ///< "Total eclipse of the Moon, 2018-07-27"
  nlohmann::ordered_json facts;
  PageArrays arrays;
};

/// Gathers limb rays, motions, albedo, responses, views, places and names. No light is computed here: the page sums it
/// from the rays, as shadow::by_quadrature does.
///
/// Throws  Error  as normal_albedo and atmosphere_of
Exploration exploration_of(const eclipse::Eclipse& eclipse, const ExploreRequest& request,
                           const algebra::Progress& progress = {});

/// Extent of the HTML: a whole page, or a fragment to embed in another page.
enum class PageExtent { whole, fragment };

/// The page as HTML that needs no other files and no network.
std::string page_of(const Exploration& exploration, PageExtent extent = PageExtent::whole);

/// A page that lists eclipses, with links to their pages.
///
/// Given  pages  file names of the pages, one for each eclipse
std::string calendar_page(const std::vector<eclipse::Eclipse>& eclipses,
                          const std::vector<std::string>& pages);

}  // namespace coppermoon::uses
