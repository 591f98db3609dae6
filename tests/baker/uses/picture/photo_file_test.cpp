// SPDX-License-Identifier: MIT
#include "uses/picture/photo_file.h"

#include <exiv2/exiv2.hpp>
#include <map>

#include "baker/texture/fits_bytes.h"
#include "baker/texture/scratch_folder.h"
#include "support/testing.h"
#include "texture/write_image.h"

namespace coppermoon::uses::photo_file_test {

const std::string date = "2019:01:21 05:12:16", local = "2019-01-21T05:12:16";

std::string local_in(const std::string& text) { return clock_in(text).value().local; }

TEST(ClockIn, ReadsDatesAsCamerasWriteThem) {
  for (const char* text : {"2019:01:21 05:12:16", "2019-01-21 05:12:16", "2019/01/21 5:12:16",
                           "2019-01-21T05:12:16.25", "2019:1:21 05:12:16  "})
    EXPECT_EQ(local_in(text), local) << text;
  EXPECT_EQ(local_in("2019:01:21 05:12"), "2019-01-21T05:12:00");
  EXPECT_EQ(local_in("2019:01:21 24:12:16"), "2019-01-21T00:12:16") << "hours from 1 to 24";
  EXPECT_EQ(clock_in("2019:01:21 05:12:16+0100"), (HeaderClock{local, "+01:00"}));
  EXPECT_EQ(clock_in("2019:01:21 05:12:16Z"), (HeaderClock{local, "+00:00"}));
  EXPECT_EQ(clock_in("2019:01:21 05:12:16Z", "-05:00"), (HeaderClock{local, "-05:00"}));
}

TEST(ClockIn, ReadsOffsetsAsCamerasWriteThem) {
  const auto offset_in = [](const std::string& text) { return clock_in(date, text)->offset; };
  EXPECT_EQ(offset_in("+03:00"), "+03:00");
  EXPECT_EQ(offset_in("-5:00"), "-05:00");
  EXPECT_EQ(offset_in("+0530"), "+05:30");
  EXPECT_EQ(offset_in("+15:59"), "+15:59");
  for (const char* utc : {"Z", "UTC", "GMT", " gmt"}) EXPECT_EQ(offset_in(utc), "+00:00");
  for (const char* unknown : {"", "   :  ", "      "}) {
    EXPECT_EQ(offset_in(unknown), std::nullopt);
    EXPECT_EQ(clock_in(date, unknown)->unread, "");
  }
}

TEST(ClockIn, KeepsTheDateBesideAnOffsetThatIsNone) {
  for (const std::string odd : {"05:00", "+99:00", "+16:00", "EST", "+5:0", "+14:60"})
    EXPECT_EQ(clock_in(date, odd), (HeaderClock{local, {}, odd}));
  EXPECT_EQ(clock_in(date + "+14:60"), (HeaderClock{local, {}, "+14:60"}));
  EXPECT_EQ(clock_in(date + "+01:00", "EST"), (HeaderClock{local, "+01:00"}));
}

TEST(ClockIn, KnowsACameraWhoseClockWasNotSet) {
  for (const char* blank :
       {"", "    :  :     :  :  ", "0000:00:00 00:00:00", "0000-00-00T00:00:00"})
    EXPECT_EQ(clock_in(blank), std::nullopt) << blank;
}

TEST(ClockIn, RefusesWhatIsNoDate) {
  for (const char* odd : {"21 January 2019", "2019:13:21 05:12:16", "2019:01:21 25:12:16",
                          "2019:01:21", "2019:02:30 05:12:16"})
    EXPECT_THROW(clock_in(odd), algebra::Error) << odd;
}

class Settings : public ScratchFolder {
 protected:
  /// Those of a file whose header says so.
  CameraSettings of(texture::Attributes header) const {
    const auto file = in_folder("a.exr");
    texture::write_exr(file, texture::Image(4, 4, {"R", "G", "B"}), header);
    return settings_of(file.string());
  }
};

TEST_F(Settings, OfACameraAreThoseThatItUses) {
  const auto found = of({{"Make", "Canon"},
                         {"Model", "Canon EOS 6D"},
                         {"Exif:ExposureTime", 1.F / 30},
                         {"Exif:FNumber", 5.6F},
                         {"Exif:PhotographicSensitivity", 6400.F}});
  EXPECT_WITHIN_RELATIVE(found.time_s.value(), 1. / 32, 1e-5, "headers are read as six digits");
  EXPECT_WITHIN_RELATIVE(found.f_number.value(), 5.656854, 1e-5, "headers are read as six digits");
  EXPECT_WITHIN_RELATIVE(found.iso.value(), 6400, 1e-5, "headers are read as six digits");
}

TEST_F(Settings, TakeTheTimeFromTheApexValue) {
  const auto time_s = [&](float shown_s, double apex) {
    return of({{"Make", "Canon"},
               {"Exif:ExposureTime", shown_s},
               {"Exif:ShutterSpeedValue", static_cast<float>(apex)}})
        .time_s.value();
  };
  const auto is = [](double found, double real) {
    EXPECT_WITHIN_RELATIVE(found, real, 1e-5, "headers are read as six digits");
  };
  is(time_s(1.F / 30, 5), 1. / 32);
  is(time_s(1.F / 30, std::log2(30.)), 1. / 32);     // as computed from the time shown
  is(time_s(1.F / 40, 5.375), std::exp2(-16. / 3));  // as Canon writes a third
  is(time_s(1.F / 20, 4.5), std::exp2(-4.5));        // half a stop, not a third
  is(time_s(0.5F, 0), 0.5);                          // absent or wrong
}

TEST_F(Settings, AreApexValuesWhereThereAreNoOthers) {
  for (const char* make : {"", "Canon"}) {
    const auto found = of({{"Make", make},
                           {"Exif:ShutterSpeedValue", 5.F},
                           {"Exif:ApertureValue", 6.F},
                           {"Exif:PhotographicSensitivity", std::vector<float>{800, 0}}});
    EXPECT_WITHIN_RELATIVE(found.time_s.value(), 1. / 32, 1e-5, "EXIF 2.32, annex C: 2^-Tv");
    EXPECT_WITHIN_RELATIVE(found.f_number.value(), 8, 1e-5, "EXIF 2.32, annex C: 2^(Av/2)");
    EXPECT_WITHIN_RELATIVE(found.iso.value(), 800, 1e-5, "the first of the list");
  }
}

TEST_F(Settings, HaveNoFNumberWithoutALens) {
  const auto found =
      of({{"Make", "Canon"}, {"Exif:ExposureTime", 0.5F}, {"Exif:ApertureValue", 2147483648.F}});
  EXPECT_EQ(found.f_number, std::nullopt) << "a camera at a telescope writes 2³¹";
  EXPECT_EQ(found.time_s, 0.5);
}

/// Photographs in FITS files, of two pixels.
class Fits : public ScratchFolder {
 protected:
  std::string of(const std::string& cards, const std::string& data = std::string(8, '\0')) const {
    return file("a.fits",
                fits_bytes(
                    "SIMPLE  = T\nBITPIX  = -32\nNAXIS   = 2\nNAXIS1  = 2\nNAXIS2  = 1\n" + cards,
                    data))
        .string();
  }
};

TEST_F(Fits, SayWhenTheyWereTakenInUtcOrInAnotherScale) {
  const auto clock = [&](const std::string& scale) {
    return clock_of(of("DATE-OBS= '2022-05-16T04:12:41.184'\n" + scale));
  };
  EXPECT_EQ(clock(""), (HeaderClock{"2022-05-16T04:12:41", "+00:00"})) << "FITS 4.0, 9.2.1: UTC";
  EXPECT_EQ(clock("TIMESYS = 'UT1'\n"), clock(""));
  EXPECT_EQ(clock("TIMESYS = 'TT(TAI)'\n").local, "2022-05-16T04:11:32") << "69.184 s behind";
  EXPECT_EQ(clock("TIMESYS = 'TAI'\n").local, "2022-05-16T04:12:04") << "37 s behind";
  EXPECT_EQ(clock("TIMESYS = 'GPS'\n").local, "2022-05-16T04:12:23") << "18 s behind";
  EXPECT_EQ(clock("TIMESYS = 'LOCAL'\n"), (HeaderClock{"2022-05-16T04:12:41", {}}));
  EXPECT_ERROR(clock("TIMESYS = 'TCB'\n"), "TIMESYS = TCB, allowed UTC");
  EXPECT_ERROR(clock_of(of("")), "does not say when it was taken");
  const std::string day = "DATE-OBS= '2022-05-16'\n";
  EXPECT_EQ(clock_of(of(day + "TIME-OBS= '04:12:41.5'\n")), clock(""));
  EXPECT_ERROR(clock_of(of(day)), "date = 2022-05-16, allowed YYYY:MM:DD HH:MM:SS");
}

TEST_F(Fits, HaveExactExposuresAndAGain) {
  const auto photo =
      of("EXPTIME = 0.0333\nFOCRATIO= 5.6\nGAIN    = 120\nINSTRUME= 'ZWO ASI294MC'\n");
  const auto found = settings_of(photo);
  EXPECT_WITHIN_RELATIVE(found.time_s.value(), 0.0333, 1e-5, "headers are read as six digits");
  EXPECT_WITHIN_RELATIVE(found.f_number.value(), 5.6, 1e-5, "headers are read as six digits");
  EXPECT_EQ(found.iso, std::nullopt);
  EXPECT_EQ(found.gain, "120");
  EXPECT_EQ(camera_of(photo), "ZWO ASI294MC");
  EXPECT_EQ(settings_of(of("EXPOSURE= 0.5\nEGAIN   = 1.25\n")).time_s, 0.5);
  EXPECT_EQ(settings_of(of("EXPOSURE= 0.5\nEGAIN   = 1.25\n")).gain, "1.25");
}

TEST_F(Fits, AreClippedAtDatamaxElseAtTheirGreatestNumber) {
  const auto clipped = [&](const std::string& cards, const std::string& greatest) {
    const auto photo = of(cards, std::string(4, '\0') + greatest);
    return clipped_at(photo, photo_light(photo, texture::Coding::as_file_says, {}));
  };
  const std::string adu("\x47\x6a\x60\0", 4), one("\x3f\x80\0\0", 4);  // 60000 and 1
  EXPECT_EQ(clipped("", adu)->light, 60000);
  EXPECT_FALSE(clipped("", adu)->of_header);
  EXPECT_EQ(clipped("DATAMAX = 65535.\n", adu)->light, 65535);
  EXPECT_TRUE(clipped("DATAMAX = 65535.\n", adu)->of_header);
  EXPECT_EQ(clipped("", one), std::nullopt) << "light ends at 1";
}

class Developer : public ScratchFolder {
 protected:
  std::string of(const texture::Attributes& header) const {
    texture::write_png(in_folder("a.png"), texture::Image(4, 4, {"R", "G", "B"}), 8, header);
    return in_folder("a.png").string();
  }
};

TEST_F(Developer, OfACamerasPhotographSaysItsCoding) {
  using enum texture::Coding;
  for (const char* program :
       {"darktable 4.2.1", "Adobe Photoshop Lightroom Classic 13.2 (Windows)", "Siril 1.2.0",
        "RawTherapee 5.9", "Capture One 23", "DxO PhotoLab 7", "GIMP 2.10.34"}) {
    const auto photo = of({{"Make", "Canon"}, {"Software", program}});
    EXPECT_EQ(developer_of(photo), program);
    EXPECT_EQ(coding_of(photo, as_file_says), as_file_says) << program;
    EXPECT_EQ(coding_of(photo, camera), camera) << "as asked for";
  }
  for (const char* firmware :
       {"", "Firmware Version 1.1.1", "ILCE-7M3 v3.10", "Ver.1.02", "Digital Photo Professional"}) {
    const auto photo = of({{"Make", "Canon"}, {"Software", firmware}});
    EXPECT_EQ(developer_of(photo), std::nullopt) << firmware;
    EXPECT_EQ(coding_of(photo, as_file_says), camera) << firmware;
  }
  EXPECT_EQ(developer_of(of({{"Software", "darktable 4.2.1"}})), std::nullopt)
      << "no camera is named";
}

TEST_F(Developer, OfAnyPictureMayBeAnEditor) {
  const auto editor = [&](const texture::Attributes& header) { return editor_of(of(header)); };
  EXPECT_EQ(editor({{"Make", "NIKON"}, {"Software", "paint.net 4.3.10"}}), "paint.net 4.3.10");
  EXPECT_EQ(editor({{"Software", "Adobe Photoshop CS6"}}), "Adobe Photoshop CS6");
  EXPECT_EQ(editor({{"Make", "Canon"}, {"Software", "darktable 4.2.1"}}), "darktable 4.2.1");
  EXPECT_EQ(editor({{"Make", "Canon"}, {"Software", "Firmware Version 1.1.1"}}), std::nullopt);
  EXPECT_EQ(
      coding_of(of({{"Make", "NIKON"}, {"Software", "paint.net"}}), texture::Coding::as_file_says),
      texture::Coding::camera)
      << "only a converter develops";
}

/// Pictures whose header Exiv2 wrote.
class Header : public ScratchFolder {
 protected:
  std::string with(const std::map<std::string, std::string>& exif,
                   const std::map<std::string, std::string>& xmp = {}) const {
    const auto file = in_folder("a.png").string();
    texture::write_png(file, texture::Image(4, 3, {"R", "G", "B"}), 8, {});
    const auto image = Exiv2::ImageFactory::open(file);
    for (const auto& [key, text] : exif) image->exifData()[key].setValue(text);
    for (const auto& [key, text] : xmp) image->xmpData()[key].setValue(text);
    image->writeMetadata();
    return file;
  }
};

TEST_F(Header, OfAPictureOfOursIsInUtc) {
  const auto file = in_folder("ours.png").string();
  texture::write_png(file, texture::Image(4, 4, {"R", "G", "B"}), 8,
                     {{"capDate", "2018:07:27 21:43:13"}, {"coppermoon:version", "0.2.0"}});
  EXPECT_EQ(clock_of(file), (HeaderClock{"2018-07-27T21:43:13", "+00:00"}));
}

TEST_F(Header, MayBeExifOrXmpInAnyFile) {
  for (const auto& photo : {with({{"Exif.Image.Make", "Canon"},
                                  {"Exif.Photo.DateTimeOriginal", date},
                                  {"Exif.Photo.OffsetTimeOriginal", "+03:00"},
                                  {"Exif.Photo.ExposureTime", "1/32"},
                                  {"Exif.Photo.FNumber", "8/1"},
                                  {"Exif.Photo.ISOSpeedRatings", "800"}}),
                            with({}, {{"Xmp.tiff.Make", "Canon"},
                                      {"Xmp.exif.DateTimeOriginal", local + "+03:00"},
                                      {"Xmp.exif.ExposureTime", "1/32"},
                                      {"Xmp.exif.FNumber", "8/1"},
                                      {"Xmp.exif.ISOSpeedRatings", "800"}})}) {
    EXPECT_EQ(camera_of(photo), "Canon");
    EXPECT_EQ(clock_of(photo), (HeaderClock{local, "+03:00"}));
    const auto exposure = exif_of(photo).value();
    EXPECT_EQ(exposure.time_s, 1. / 32);
    EXPECT_EQ(exposure.f_number, 8);
    EXPECT_EQ(exposure.iso, 800);
  }
}

TEST_F(Header, TellsThatAnUnnamedProgramChangedTheSize) {
  const auto editor = [&](const char* width, const char* height) {
    return editor_of(with({{"Exif.Image.Make", "SONY"},
                           {"Exif.Image.Software", "ILCE-6000 v3.20"},
                           {"Exif.Photo.PixelXDimension", width},
                           {"Exif.Photo.PixelYDimension", height}}));
  };
  EXPECT_EQ(editor("4", "3"), std::nullopt);
  EXPECT_EQ(editor("3", "4"), std::nullopt) << "turned";
  EXPECT_EQ(editor("6000", "4000"), "a program that the header does not name");
  EXPECT_EQ(editor_of(with({{"Exif.Image.Make", "SONY"}})), std::nullopt) << "no size is stated";
}

TEST_F(Header, NamesTheProgramThatDeveloped) {
  const std::string lightroom = "Adobe Photoshop Lightroom Classic 13.2 (Windows)";
  EXPECT_EQ(
      developer_of(with({{"Exif.Image.Make", "Canon"}}, {{"Xmp.xmp.CreatorTool", lightroom}})),
      lightroom);
  EXPECT_EQ(
      developer_of(with({{"Exif.Image.Make", "Canon"}}, {{"Xmp.crs.AlreadyApplied", "True"}})),
      "Adobe Camera Raw");
  EXPECT_EQ(
      developer_of(with({{"Exif.Image.Make", "Canon"}}, {{"Xmp.crs.AlreadyApplied", "False"}})),
      std::nullopt)
      << "settings kept beside a camera's own numbers";
}

TEST_F(Header, SaysWhenItWasByGps) {
  const HeaderClock utc{local, "+00:00"};
  EXPECT_EQ(gps_clock_of(with({{"Exif.GPSInfo.GPSDateStamp", "2019:01:21"},
                               {"Exif.GPSInfo.GPSTimeStamp", "5/1 12/1 1699/100"}})),
            utc);
  EXPECT_EQ(gps_clock_of(with({}, {{"Xmp.exif.GPSTimeStamp", "2019-01-21T05:12:16Z"}})), utc);
  for (const char* day : {"", "2019:13:21", "0000:00:00"})
    EXPECT_EQ(gps_clock_of(with({{"Exif.GPSInfo.GPSDateStamp", day},
                                 {"Exif.GPSInfo.GPSTimeStamp", "5/1 12/1 16/1"}})),
              std::nullopt)
        << day;
  EXPECT_EQ(gps_clock_of(with({{"Exif.Photo.DateTimeOriginal", date}})), std::nullopt);
}

TEST_F(Settings, OfOurOwnFilesStayAsTheyWereAskedFor) {
  for (const char* make : {"coppermoon", ""})
    EXPECT_WITHIN_RELATIVE(of({{"Make", make}, {"expTime", 1.F / 30}}).time_s.value(), 1. / 30,
                           1e-5, "headers are read as six digits");
}

}  // namespace coppermoon::uses::photo_file_test
