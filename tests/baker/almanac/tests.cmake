# SPDX-License-Identifier: MIT
coppermoon_tests(baker/almanac LINKS coppermoon::almanac PkgConfig::ERFA QUICK calendar ephemeris gazetteer instant observer planets sky stars)
