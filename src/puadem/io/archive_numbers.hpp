#pragma once

#include <array>
#include <concepts>
#include <cstring>
#include <type_traits>

#include "puadem/base/compensated_sum.hpp"
#include "puadem/base/gaussian_mixture.hpp"
#include "puadem/base/vec3.hpp"
#include "puadem/dem/grain_system.hpp"
#include "puadem/flow/invasion.hpp"
#include "puadem/geometry/facets.hpp"

namespace puadem {

/// A value as a row of numbers of one kind: how many, of which kind, there and back.
template <class T>
struct Numbers;

template <class T>
concept IsNumbers = requires {
  typename Numbers<T>::Kind;
};

template <class T>
requires std::is_arithmetic_v<T> || std::is_enum_v<T>
struct Numbers<T> {
  using Kind =
      typename std::conditional_t<std::is_enum_v<T>, std::underlying_type<T>,
                                  std::type_identity<std::conditional_t<std::is_same_v<T, bool>, std::uint8_t, T>>>::type;
  static constexpr std::size_t count = 1;
  static void put(const T& value, Kind* to) { *to = static_cast<Kind>(value); }
  static void get(const Kind* from, T& value) { value = static_cast<T>(*from); }
};

template <IsNumbers T, std::size_t n>
struct Numbers<std::array<T, n>> {
  using Kind = typename Numbers<T>::Kind;
  static constexpr std::size_t each = Numbers<T>::count, count = n * each;
  static void put(const std::array<T, n>& value, Kind* to) {
    for (std::size_t k = 0; k < n; ++k) Numbers<T>::put(value[k], to + k * each);
  }
  static void get(const Kind* from, std::array<T, n>& value) {
    for (std::size_t k = 0; k < n; ++k) Numbers<T>::get(from + k * each, value[k]);
  }
};

/// Structs of doubles and of nothing else.
template <class T>
struct AllDoubles {
  using Kind = double;
  static constexpr std::size_t count = sizeof(T) / sizeof(double);
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(double) == 0);
  static void put(const T& value, double* to) { std::memcpy(to, &value, sizeof(T)); }
  static void get(const double* from, T& value) { std::memcpy(static_cast<void*>(&value), from, sizeof(T)); }
};
// clang-format off
template <> struct Numbers<Vec3> : AllDoubles<Vec3> {};
template <> struct Numbers<CompensatedSum> : AllDoubles<CompensatedSum> {};
template <> struct Numbers<NormalPart> : AllDoubles<NormalPart> {};
template <> struct Numbers<LaneVec3> : AllDoubles<LaneVec3> {};
template <> struct Numbers<GrainRecord> : AllDoubles<GrainRecord> {};
template <> struct Numbers<ContactSlot> : AllDoubles<ContactSlot> {};
template <> struct Numbers<RollSlot> : AllDoubles<RollSlot> {};
template <> struct Numbers<RollHistory> : AllDoubles<RollHistory> {};
template <> struct Numbers<ViscousHistory> : AllDoubles<ViscousHistory> {};
// clang-format on

/// Structs of small integers, written as those of an array.
template <class T, std::size_t n>
struct AsIntegers {
  using Kind = int;
  static constexpr std::size_t count = n;
};

template <>
struct Numbers<Vertex> : AsIntegers<Vertex, 4> {
  static void put(const Vertex& v, int* to) {
    to[0] = v.index;
    for (std::size_t a = 0; a < 3; ++a) to[a + 1] = v.shift[a];
  }
  static void get(const int* from, Vertex& v) {
    v.index = from[0];
    for (std::size_t a = 0; a < 3; ++a) v.shift[a] = static_cast<std::int8_t>(from[a + 1]);
  }
};

template <>
struct Numbers<Triangulation::Neighbour> : AsIntegers<Triangulation::Neighbour, 4> {
  static void put(const Triangulation::Neighbour& n, int* to) {
    to[0] = n.cell;
    for (std::size_t a = 0; a < 3; ++a) to[a + 1] = n.shift[a];
  }
  static void get(const int* from, Triangulation::Neighbour& n) {
    n.cell = from[0];
    for (std::size_t a = 0; a < 3; ++a) n.shift[a] = static_cast<std::int8_t>(from[a + 1]);
  }
};

template <>
struct Numbers<Facet> : AsIntegers<Facet, 6> {
  static void put(const Facet& f, int* to) {
    to[0] = f.cell;
    to[1] = f.neighbour;
    for (std::size_t a = 0; a < 3; ++a) to[a + 2] = f.shift[a];
    to[5] = f.opposite;
  }
  static void get(const int* from, Facet& f) {
    f.cell = from[0];
    f.neighbour = from[1];
    for (std::size_t a = 0; a < 3; ++a) f.shift[a] = static_cast<std::int8_t>(from[a + 2]);
    f.opposite = static_cast<std::int8_t>(from[5]);
  }
};

template <>
struct Numbers<InvasionCandidate> {
  using Kind = double;  // an index fits
  static constexpr std::size_t count = 4;
  static void put(const InvasionCandidate& c, double* to) {
    to[0] = c.pressure;
    to[1] = c.entry;
    to[2] = c.index;
    to[3] = static_cast<double>(c.kind);
  }
  static void get(const double* from, InvasionCandidate& c) {
    c = {from[0], from[1], static_cast<int>(from[2]), static_cast<InvasionCandidate::Kind>(from[3])};
  }
};

}  // namespace puadem
