# SPDX-License-Identifier: MIT
coppermoon_tests(baker/uses/film LINKS coppermoon::film HEAVY film_folder film_light film_scene film_sheet film_times fixed_view frame_range frame_rate)
