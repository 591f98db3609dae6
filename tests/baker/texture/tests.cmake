# SPDX-License-Identifier: MIT
foreach(noun contact_sheet read_image whole_file write_image)
  coppermoon_test(baker/texture/${noun} LINKS texture LABELS files)
endforeach()
coppermoon_test(baker/texture/bake LINKS texture)
target_link_libraries(baker_texture_bake_test PRIVATE TBB::tbb)
