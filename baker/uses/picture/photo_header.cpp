// SPDX-License-Identifier: MIT
#include "uses/picture/photo_header.h"

#include <exception>
#include <exiv2/exiv2.hpp>
#include <mutex>

#include "algebra/number.h"

namespace coppermoon::uses {

PhotoHeader photo_header(const std::string& photo) try {
  static std::mutex one_at_a_time;  // Exiv2's XMP parser is not thread-safe at first use
  const std::scoped_lock lock(one_at_a_time);
  Exiv2::LogMsg::setLevel(Exiv2::LogMsg::mute);
  const auto image = Exiv2::ImageFactory::open(photo);
  image->readMetadata();
  PhotoHeader header{{"FileWidth", std::to_string(image->pixelWidth())},
                     {"FileHeight", std::to_string(image->pixelHeight())}};
  for (const auto& one : image->exifData()) {
    const auto group = one.groupName();
    const bool bytes = one.typeId() == Exiv2::undefined || one.typeId() == Exiv2::unsignedByte;
    const bool balance = (group == "Nikon3" && one.tagName() == "WB_RBLevels") ||
                         (group == "Canon" && one.tagName() == "ColorData");
    if (!bytes && (group == "Image" || group == "Photo" || group == "GPSInfo" || balance))
      header.emplace(one.tagName(), one.toString());
  }
  for (const auto& one : image->xmpData()) {
    const auto key =
        one.key();  // such as "Xmp.exif.ExposureTime", "Xmp.xmpMM.History[1]/stEvt:softwareAgent"
    header.emplace(key.substr(key.find_last_of(".:") + 1), one.toString());
  }
  return header;
} catch (const std::exception&) {  // the file has no readable header
  return {};
}

std::optional<double> first_number(const std::string& text) {
  const auto first = text.substr(0, text.find_first_of(", "));
  const auto bar = first.find('/');
  const auto over = algebra::number_in(first.substr(0, bar)),
             under = bar == first.npos ? 1 : algebra::number_in(first.substr(bar + 1));
  return over && under ? std::optional(*over / *under) : std::nullopt;
}

}  // namespace coppermoon::uses
