# SPDX-License-Identifier: MIT
coppermoon_tests(baker/almanac LINKS coppermoon::almanac QUICK ephemeris gazetteer instant observer sky)
