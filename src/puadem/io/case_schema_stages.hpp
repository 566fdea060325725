#pragma once

#include "puadem/coupling/case.hpp"
#include "puadem/io/case_fields.hpp"
#include "puadem/io/key_builders.hpp"

namespace puadem {

/// Keys of one kind of [[stage]].
template <class S>
const Section<S>& stage_section();

template <>
const Section<CompactStage>& stage_section();
template <>
const Section<PermeabilityStage>& stage_section();
template <>
const Section<RetentionStage>& stage_section();
template <>
const Section<TwoPhaseStage>& stage_section();
template <>
const Section<IsotropicStage>& stage_section();
template <>
const Section<OedometerStage>& stage_section();
template <>
const Section<TriaxialStage>& stage_section();
template <>
const Section<ShearStage>& stage_section();
template <>
const Section<SettleStage>& stage_section();
template <>
const Section<StrainStage>& stage_section();
template <>
const Section<SaturatedStage>& stage_section();
template <>
const Section<UnsaturatedStage>& stage_section();

/// Keys of cooperative filling, the same in all stages of two fluids.
KeyInfo cooperative_filling_key();
KeyInfo filling_seed_key();

/// The key `kind`, which tells the stages apart and stores nothing.
template <class S>
Field<S> kind_field(std::string help) {
  const std::string word(S::kind);
  KeyInfo info = needed(plain("kind", "a choice", std::move(help), toml_text(word)));
  return {std::move(info), [](const TomlValue&, Problems&, S&) {}, [word](const S&) { return toml_text(word); }};
}

}  // namespace puadem
