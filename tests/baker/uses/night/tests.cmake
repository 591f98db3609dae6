# SPDX-License-Identifier: MIT
coppermoon_tests(baker/uses/night LINKS coppermoon::night HEAVY circumstances night_light star_limit visibility_map)
