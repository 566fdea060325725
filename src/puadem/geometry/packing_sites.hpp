#pragma once

#include <array>
#include <span>

#include "puadem/base/parallel.hpp"
#include "puadem/geometry/regular_triangulation.hpp"
#include "puadem/geometry/site.hpp"

namespace puadem {

/// Vertices of a triangulation as geometry sees them.
class PackingSites {
 public:
  PackingSites(std::span<const Vec3> centre, std::span<const double> radius, const Domain& domain)
      : centre_(centre), radius_(radius), period_(domain.size()) {
    for (int face = 0; face < 6; ++face) {
      const Vec3 normal = outward_normal(face);
      walls_[to_size(face)] = Site::wall(normal, normal[axis_of(face)] * domain.face_position(face));
    }
  }

  Site operator()(const Vertex& v) const {
    if (v.is_wall()) return walls_[to_size(v.face())];
    return Site::grain(centre_of(v), radius_of(v));
  }

  /// Of a vertex that is a grain [m].
  Vec3 centre_of(const Vertex& v) const { return centre_[to_size(v.index)] + translation(v.shift); }
  double radius_of(const Vertex& v) const { return radius_[to_size(v.index)]; }

  template <std::size_t N>
  std::array<Site, N> operator()(const std::array<Vertex, N>& vertices) const {
    std::array<Site, N> sites;
    for (std::size_t k = 0; k < N; ++k) sites[k] = (*this)(vertices[k]);
    return sites;
  }

  /// How far whole periods move a point [m].
  Vec3 translation(const std::array<std::int8_t, 3>& shift) const {
    return {shift[0] * period_.x, shift[1] * period_.y, shift[2] * period_.z};
  }

 private:
  std::span<const Vec3> centre_;
  std::span<const double> radius_;
  Vec3 period_;
  std::array<Site, 6> walls_;
};

}  // namespace puadem
