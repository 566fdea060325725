#pragma once

namespace puadem {

/// Inscribed radius coefficient chi_g of a pore unit with n_f faces: R = chi_g V^(1/3). Regular
/// polyhedra of 4, 6, 8, 12 and 20 faces, log-linear in n_f between them and beyond the last up to
/// 0.605, below the sphere's (3 / 4 pi)^(1/3) (theory 3.6). Fewer than 4 faces count as 4.
double inscribed_radius_coefficient(int faces);

}  // namespace puadem
