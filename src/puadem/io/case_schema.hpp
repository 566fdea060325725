#pragma once

#include "puadem/coupling/case.hpp"
#include "puadem/io/case_fields.hpp"

namespace puadem {

/// The table of all keys of a case file. It reads (case_file.cpp), writes the resolved case and makes
/// the documentation: a new key is one line here.
const Section<Case>& case_section();

/// The list [[stage]].
Field<Case> stages_field();

}  // namespace puadem
