# SPDX-License-Identifier: MIT
coppermoon_tests(baker/verbs/flags LINKS coppermoon::verbs HEAVY effects film_options help light_options moments named_files)
coppermoon_tests(baker/verbs/recipes LINKS coppermoon::verbs HEAVY recipe round_trip)
coppermoon_tests(baker/verbs/reports LINKS coppermoon::verbs HEAVY in_words one_line progress_bar writers)
coppermoon_tests(baker/verbs/manuals LINKS coppermoon::verbs HEAVY manuals)
