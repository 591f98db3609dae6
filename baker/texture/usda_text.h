// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace coppermoon::texture {

/// A text between quotes, on one line, that USD reads back as it was.
std::string usda_quoted(std::string_view text);

/// A file beside this one, between as many @ as its name takes.
std::string usda_asset(std::string_view file_name);

/// A dictionary's key: quotes where it is no identifier.
std::string usda_key(std::string_view name);

/// The string that stands under a name in a dictionary of the layer's customLayerData.
///
/// Given  layer  USD text, or the beginning of it
std::optional<std::string> string_in_layer_data(std::string_view layer, std::string_view dictionary,
                                                std::string_view name);

}  // namespace coppermoon::texture
