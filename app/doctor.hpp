#pragma once

#include <string>

namespace puadem {

/// Version, commit, compiler and kind of build.
std::string version_text();

/// Looks at what a run needs and prints it; says what to do about what is missing. @return whether all is there
bool doctor();

}  // namespace puadem
