# SPDX-License-Identifier: MIT
coppermoon_test(baker/shadow/irradiance LINKS shadow)
coppermoon_test(baker/shadow/by_quadrature LINKS shadow)
coppermoon_test(baker/shadow/lookup LINKS shadow)
coppermoon_test(baker/shadow/twilight LINKS shadow)
coppermoon_test(baker/shadow/umbra LINKS shadow colour)
coppermoon_test(baker/shadow/by_photons LINKS shadow)
target_link_libraries(baker_shadow_by_photons_test PRIVATE TBB::tbb)
coppermoon_test(baker/shadow/convergence LINKS shadow LABELS slow TIMEOUT 1500)
