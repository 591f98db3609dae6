// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace coppermoon::verbs {

/// What CLI11 says of a command line, in the words of all other errors: the value, and what is allowed.
/// A text of another kind stays as it is.
///
/// Given  error  as "--quality: best not in {draft,standard}"
std::string plain_error(const std::string& error);

}  // namespace coppermoon::verbs
