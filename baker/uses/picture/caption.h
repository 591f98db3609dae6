// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "almanac/instant.h"
#include "almanac/observer.h"
#include "eclipse/contacts.h"
#include "texture/image.h"

namespace coppermoon::uses {

/// Name of the nearest city where it is less than 10 km away, else degrees: "34.05° N, 118.24° W".
std::string place_in_words(const almanac::Observer& observer);

/// Contact nearest to a moment, and the time from it: "U2", "U2+12min", "U2-40s".
std::string from_nearest_contact(const eclipse::Eclipse& eclipse, const almanac::Instant& when);

/// The same of a contact and the seconds from it on.
std::string from_contact(const std::string& name, double seconds);

/// Texts under the left and right end of a picture.
struct Caption {
  std::string
      left;  ///< local time, and the place: "2018-07-27 23:21:45 EAT, Nairobi"; in UTC without one
  std::string right;  ///< of an eclipse: the time from its nearest contact
};

/// Given  header  of a scene-linear frame: `capDate`, `latitude`, `longitude`
///
/// Throws  Error  when it has no moment
Caption caption_of(const texture::Attributes& header);

}  // namespace coppermoon::uses
