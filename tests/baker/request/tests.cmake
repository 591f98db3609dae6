# SPDX-License-Identifier: MIT
coppermoon_tests(baker/request LINKS coppermoon::request QUICK likeness parameter recipe)
