#pragma once

#include "puadem/coupling/case.hpp"
#include "puadem/io/case_fields.hpp"

namespace puadem {

/// What cannot be together in the table [bridges], and with the stages. @param tree  of the case
void check_bridges(const TomlValue& tree, const Case& c, Problems& problems);

}  // namespace puadem
