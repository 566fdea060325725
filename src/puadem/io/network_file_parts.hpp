#pragma once

#include <optional>
#include <string_view>

#include "puadem/network/pore_network.hpp"

namespace puadem {

/// Number that a whole field of a text file spells.
std::optional<double> field_number(std::string_view field);

/// Fills what a file leaves open once pores, throats and their radii are known: arrays of throats, lists of throats.
/// @throws InputError  where the network is not sound, with the first faults
void complete_network(PoreNetwork& network, std::string_view name);

/// Leaves out the pores, and their throats, that cannot be reached from any pore with a face; returns their number.
int drop_unreachable_pores(PoreNetwork& network);

}  // namespace puadem
