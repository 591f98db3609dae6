// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace coppermoon::verbs {

/// CLI11's error in the words of all other errors: the value, and what is allowed. Any other text stays as it is.
///
/// Given  error  as "--quality: best not in {draft,standard}"
std::string plain_error(const std::string& error);

}  // namespace coppermoon::verbs
