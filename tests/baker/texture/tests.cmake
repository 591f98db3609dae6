# SPDX-License-Identifier: MIT
coppermoon_tests(baker/texture LINKS coppermoon::texture nlohmann_json::nlohmann_json PkgConfig::LCMS PkgConfig::OpenImageIO PkgConfig::TIFF TBB::tbb ZLIB::ZLIB
  QUICK bake contact_sheet how_stored raw read_image seal sphere_mesh write_glb write_image write_stellarium write_usda write_usdz)
