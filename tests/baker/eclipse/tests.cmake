# SPDX-License-Identifier: MIT
coppermoon_tests(baker/eclipse LINKS coppermoon::eclipse QUICK contacts feature moment shadow_axis shadow_cone sky_columns)
