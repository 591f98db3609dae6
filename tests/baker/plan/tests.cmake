# SPDX-License-Identifier: MIT
coppermoon_test(baker/plan/laws LINKS plan)
coppermoon_test(baker/plan/plan LINKS plan)
