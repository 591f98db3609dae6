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

/// What an eclipse is explored with.
struct ExploreRequest {
  MoonRequest moon{};  ///< map, photometry, and of its light the air and the Sun
  std::optional<almanac::Observer>
      observer{};                    ///< who looks when the page opens; none: the Earth's centre
  std::string place{}, time_zone{};  ///< the observer's
  std::string options{};  ///< of the command line, that the page adds to the commands it shows
};

/// All numbers that a page needs to light the Moon of one eclipse at any moment of it.
struct Exploration {
  std::string title;  ///< "Total eclipse of the Moon, 2018-07-27"
  nlohmann::ordered_json facts;
  PageArrays arrays;
};

/// Gathers them: limb rays, motions, albedo, responses, views, places, names. No light is computed: the
/// page sums it up itself, as shadow::by_quadrature does, from rays of the same table.
///
/// Throws  Error  as normal_albedo and atmosphere_of
Exploration exploration_of(const eclipse::Eclipse& eclipse, const ExploreRequest& request,
                           const algebra::Progress& progress = {});

/// Whether an HTML text is a page by itself, or a part for somebody's own.
enum class PageExtent { whole, fragment };

/// The page: one text that needs no other file and no network.
std::string page_of(const Exploration& exploration, PageExtent extent = PageExtent::whole);

/// A page that lists eclipses and links to their own.
///
/// Given  pages  for each eclipse the name of its page's file
std::string calendar_page(const std::vector<eclipse::Eclipse>& eclipses,
                          const std::vector<std::string>& pages);

}  // namespace coppermoon::uses
