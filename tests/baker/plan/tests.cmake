# SPDX-License-Identifier: MIT
coppermoon_tests(baker/plan LINKS coppermoon::plan QUICK laws plan)
