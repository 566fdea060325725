#pragma once

#include "puadem/coupling/case.hpp"
#include "puadem/io/case_fields.hpp"

namespace puadem {

/// The table of all keys of a case file. It reads (case_file.cpp), writes the resolved case and makes
/// the documentation: a new key is one line here.
const Section<Case>& case_section();

/// The tables [grains], [materials.NAME] and [contact].
const Section<GrainOptions>& grains_section();
Field<Case> materials_field();
const Section<ContactOptions>& contact_section();

/// The table [pores].
const Section<PoreOptions>& pores_section();

/// The table [bridges].
Field<Case> bridges_field();

/// The table [network], in place of grains.
Field<Case> network_field();

/// A table that is of no meaning, and not written, where the case has a network in place of grains.
Field<Case> only_with_grains(Field<Case> field);

/// The table [pores]; beside a network from a file only the bounds of conductances.
Field<Case> pores_field();

/// The list [[stage]].
Field<Case> stages_field();

}  // namespace puadem
