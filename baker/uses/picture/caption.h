// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "almanac/instant.h"
#include "almanac/observer.h"
#include "eclipse/contacts.h"
#include "texture/image.h"

namespace coppermoon::uses {

/// Name of the nearest city if it is less than 10 km away, otherwise degrees: "34.05° N, 118.24° W".
std::string place_in_words(const almanac::Observer& observer);

/// The contact nearest to a moment, and the time since or until it: "U2", "U2+12min", "U2-40s".
std::string from_nearest_contact(const eclipse::Eclipse& eclipse, const almanac::Instant& when);

/// Text for a time relative to a contact, such as "U2+12min"; negative seconds are before the contact.
std::string from_contact(const std::string& name, double seconds);

/// Texts below a picture, at its left and right ends.
struct Caption {
  std::string
      left;  ///< local time and place: "2018-07-27 23:21:45 EAT, Nairobi"; UTC if there is no place
  std::string right;  ///< during an eclipse, the time from its nearest contact
};

/// The caption for a scene-linear frame, from `capDate`, `latitude` and `longitude` in its header.
///
/// Throws  Error  when the header has no `capDate`
Caption caption_of(const texture::Attributes& header);

}  // namespace coppermoon::uses
