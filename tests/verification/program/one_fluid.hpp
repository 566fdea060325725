#pragma once

#include <filesystem>

namespace puadem::verification {

/// Throats of lattices against their closed forms; the sum of all throat domains against the void.
void write_throats(const std::filesystem::path& folder);

/// Permeability of lattices beside its closed form, exact Stokes flow and Kozeny and Carman.
void write_lattices(const std::filesystem::path& folder);

/// Permeability of dense random packings of several sizes, periodic and between walls.
void write_random_packings(const std::filesystem::path& folder);

/// Pressure along columns of several sizes against the straight line.
void write_columns(const std::filesystem::path& folder);

/// What permeability must not depend on.
void write_invariances(const std::filesystem::path& folder);

}  // namespace puadem::verification
