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

/// Request for the page of an eclipse.
struct ExploreRequest {
  MoonRequest moon{};  ///< map, photometry, and of its light the air and the Sun
  std::optional<almanac::Observer> observer{};  ///< when the page opens; none: the Earth's centre
  std::string place{}, time_zone{};             ///< the observer's
  std::string options{};                        ///< options that end each command the page shows
};

/// Numbers by which a page lights the Moon at any moment of one eclipse.
struct Exploration {
  std::string title;  ///< "Total eclipse of the Moon, 2018-07-27"
  nlohmann::ordered_json facts;
  PageArrays arrays;
};

/// Gathers limb rays, motions, albedo, responses, views, places and names. No light is computed: the page sums it up
/// from the rays, as shadow::by_quadrature does.
///
/// Throws  Error  as normal_albedo and atmosphere_of
Exploration exploration_of(const eclipse::Eclipse& eclipse, const ExploreRequest& request,
                           const algebra::Progress& progress = {});

/// Extent of an HTML text: a page, or a fragment for another page.
enum class PageExtent { whole, fragment };

/// HTML text that needs no other file and no network.
std::string page_of(const Exploration& exploration, PageExtent extent = PageExtent::whole);

/// Page that lists eclipses, with links to their pages.
///
/// Given  pages  names of their files, one for each eclipse
std::string calendar_page(const std::vector<eclipse::Eclipse>& eclipses,
                          const std::vector<std::string>& pages);

}  // namespace coppermoon::uses
