#pragma once

#include <cassert>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "puadem/base/error.hpp"
#include "puadem/io/archive_numbers.hpp"
#include "puadem/io/hdf5_file.hpp"

// Values to and from an HDF5 file. A struct is listed once, by a function
//   void fields(auto& archive, Is<Thing> auto& thing);
// that hands its members to the archive by name; the same list writes and reads. Listing them through a structured
// binding makes a member that was forgotten an error of the compiler.

namespace puadem {

template <class X, class T>
concept Is = std::same_as<std::remove_const_t<X>, T>;

/// Structs without lists in them: a vector of them is written as one table or list of texts for each member.
template <class T>
inline constexpr bool is_row = false;

/// Hands values to an archive by the words of `names`.
template <class Archive, class... Values>
void each(Archive& archive, std::string_view names, Values&... values) {
  const auto next = [&] {
    const std::size_t end = names.find(' ');
    const std::string name(names.substr(0, end));
    assert(!name.empty());
    names.remove_prefix(end == std::string_view::npos ? names.size() : end + 1);
    return name;
  };
  (archive(next(), values), ...);
  assert(names.empty());
}

template <class T>
inline constexpr bool is_list = false;
template <class T, class A>
inline constexpr bool is_list<std::vector<T, A>> = true;
template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;
template <class T>
inline constexpr bool is_variant = false;
template <class... T>
inline constexpr bool is_variant<std::variant<T...>> = true;

/// The members of many structs, each as one column.
struct ArchiveColumns {
  struct Column {
    Hdf5Kind kind;
    std::size_t width;
    std::vector<unsigned char> bytes;
  };
  std::map<std::string, Column> numbers;
  std::map<std::string, std::vector<std::string>> texts;
};

/// Adds a row to columns.
struct RowWriter {
  ArchiveColumns& columns;
  std::string prefix = {};

  template <class T>
  void operator()(const std::string& name, const T& value) {
    if constexpr (IsNumbers<T>) {
      using N = Numbers<T>;
      const auto size = sizeof(typename N::Kind) * N::count;
      auto& column = columns.numbers.try_emplace(prefix + name, hdf5_kind<typename N::Kind>, N::count).first->second;
      column.bytes.resize(column.bytes.size() + size);
      std::array<typename N::Kind, N::count> row;
      N::put(value, row.data());
      std::memcpy(column.bytes.data() + column.bytes.size() - size, row.data(), size);
    } else if constexpr (std::is_same_v<T, std::string>) {
      columns.texts[prefix + name].push_back(value);
    } else if constexpr (is_optional<T>) {
      (*this)(name + "_given", value.has_value());
      (*this)(name, value.value_or(typename T::value_type{}));
    } else {
      RowWriter inner{columns, prefix + name + "."};
      fields(inner, value);
    }
  }
};

/// Reads a row of columns.
struct RowReader {
  const ArchiveColumns& columns;
  std::size_t row;
  std::string prefix = {};

  template <class T>
  void operator()(const std::string& name, T& value) {
    if constexpr (IsNumbers<T>) {
      using N = Numbers<T>;
      const auto size = sizeof(typename N::Kind) * N::count;
      const auto found = columns.numbers.find(prefix + name);
      require(found != columns.numbers.end() && found->second.bytes.size() >= (row + 1) * size, "no column \"{}\"",
              prefix + name);
      std::array<typename N::Kind, N::count> numbers;
      std::memcpy(numbers.data(), found->second.bytes.data() + row * size, size);
      N::get(numbers.data(), value);
    } else if constexpr (std::is_same_v<T, std::string>) {
      const auto found = columns.texts.find(prefix + name);
      require(found != columns.texts.end() && found->second.size() > row, "no texts \"{}\"", prefix + name);
      value = found->second[row];
    } else if constexpr (is_optional<T>) {
      bool is_given = false;
      (*this)(name + "_given", is_given);
      value.emplace();
      (*this)(name, *value);
      if (!is_given) value.reset();
    } else {
      RowReader inner{columns, row, prefix + name + "."};
      fields(inner, value);
    }
  }
};

/// Writes values under names in a group of the file.
class ArchiveWriter {
 public:
  explicit ArchiveWriter(Hdf5File& file, std::string group = {}) : file_(file), group_(std::move(group)) {}

  /// Writes into a group of this one.
  ArchiveWriter inside(const std::string& name) { return ArchiveWriter(file_, group_ + name + "/"); }

  template <class T>
  void operator()(const std::string& name, const T& value) {
    if constexpr (IsNumbers<T>) {
      numbers(name, &value, 1);
    } else if constexpr (std::is_same_v<T, std::string>) {
      file_.write(group_ + name, std::vector{value});
    } else if constexpr (is_optional<T>) {
      if (value) (*this)(name, *value);
    } else if constexpr (is_variant<T>) {
      ArchiveWriter inner = inside(name);
      inner("kind", static_cast<int>(value.index()));
      std::visit(
          [&]<class V>(const V& v) {
            if constexpr (!std::is_same_v<V, std::monostate>) inner("value", v);
          },
          value);
    } else if constexpr (is_list<T>) {
      list(name, value);
    } else {
      ArchiveWriter inner = inside(name);
      inner("is_here", true);
      fields(inner, value);
    }
  }

  void operator()(const std::string& name, const std::map<std::string, double>& values) {
    std::vector<std::string> keys;
    std::vector<double> numbers;
    for (const auto& [key, value] : values) {
      keys.push_back(key);
      numbers.push_back(value);
    }
    (*this)(name + "_names", keys);
    (*this)(name, numbers);
  }

 private:
  template <class T>
  void numbers(const std::string& name, const T* values, std::size_t n) {
    using N = Numbers<T>;
    std::vector<typename N::Kind> rows(n * N::count);
    for (std::size_t k = 0; k < n; ++k) N::put(values[k], rows.data() + k * N::count);
    file_.write(group_ + name, rows.data(), hdf5_kind<typename N::Kind>, n, N::count);
  }

  template <class T, class A>
  void list(const std::string& name, const std::vector<T, A>& values) {
    if constexpr (IsNumbers<T>) {
      numbers(name, values.data(), values.size());
    } else if constexpr (std::is_same_v<T, std::string>) {
      file_.write(group_ + name, values);
    } else {
      ArchiveWriter inner = inside(name);
      inner("size", static_cast<std::int64_t>(values.size()));
      if constexpr (is_row<T>) {
        ArchiveColumns columns;
        for (const T& value : values) {
          RowWriter row{columns};
          fields(row, value);
        }
        for (const auto& [key, column] : columns.numbers)
          file_.write(inner.group_ + key, column.bytes.data(), column.kind, values.size(), column.width);
        for (const auto& [key, texts] : columns.texts) file_.write(inner.group_ + key, texts);
      } else {
        for (std::size_t k = 0; k < values.size(); ++k) inner(std::to_string(k), values[k]);
      }
    }
  }

  Hdf5File& file_;
  std::string group_;
};

/// Reads what an ArchiveWriter wrote. @throws InputError (from its calls) where a name is missing or of another kind
class ArchiveReader {
 public:
  explicit ArchiveReader(const Hdf5File& file, std::string group = {}) : file_(file), group_(std::move(group)) {}

  /// Reads from a group of this one.
  ArchiveReader inside(const std::string& name) const { return ArchiveReader(file_, group_ + name + "/"); }

  template <class T>
  void operator()(const std::string& name, T& value) {
    if constexpr (IsNumbers<T>) {
      using N = Numbers<T>;
      constexpr Hdf5Kind kind = hdf5_kind<typename N::Kind>;
      require(file_.rows(group_ + name, kind, N::count) == 1, "\"{}\" should be one value", group_ + name);
      std::array<typename N::Kind, N::count> row;
      file_.read(group_ + name, row.data(), kind);
      N::get(row.data(), value);
    } else if constexpr (std::is_same_v<T, std::string>) {
      const std::vector<std::string> one = file_.read_texts(group_ + name);
      require(one.size() == 1, "\"{}\" should be one text", group_ + name);
      value = one.front();
    } else if constexpr (is_optional<T>) {
      value.reset();
      if (file_.has(group_ + name)) (*this)(name, value.emplace());
    } else if constexpr (is_variant<T>) {
      ArchiveReader inner = inside(name);
      int kind = 0;
      inner("kind", kind);
      take_alternative(inner, kind, value, std::make_index_sequence<std::variant_size_v<T>>{});
    } else if constexpr (is_list<T>) {
      list(name, value);
    } else {
      ArchiveReader inner = inside(name);
      fields(inner, value);
    }
  }

  void operator()(const std::string& name, std::map<std::string, double>& values) {
    std::vector<std::string> keys;
    std::vector<double> numbers;
    (*this)(name + "_names", keys);
    (*this)(name, numbers);
    require(keys.size() == numbers.size(), "\"{}\" has {} names for {} numbers", group_ + name, keys.size(), numbers.size());
    values.clear();
    for (std::size_t k = 0; k < keys.size(); ++k) values[keys[k]] = numbers[k];
  }

 private:
  template <class V, std::size_t... k>
  static void take_alternative(ArchiveReader& inner, int kind, V& value, std::index_sequence<k...>) {
    const auto take = [&]<std::size_t i>(std::integral_constant<std::size_t, i>) {
      if (kind != static_cast<int>(i)) return false;
      auto& alternative = value.template emplace<i>();
      if constexpr (!std::is_same_v<std::variant_alternative_t<i, V>, std::monostate>) inner("value", alternative);
      return true;
    };
    const bool taken = (take(std::integral_constant<std::size_t, k>{}) || ...);
    require(taken, "\"{}\" has the unknown kind {}", inner.group_, kind);
  }

  template <class T, class A>
  void numbers(const std::string& name, std::vector<T, A>& values) {
    using N = Numbers<T>;
    const std::size_t n = file_.rows(group_ + name, hdf5_kind<typename N::Kind>, N::count);
    std::vector<typename N::Kind> rows(n * N::count);
    if (n > 0) file_.read(group_ + name, rows.data(), hdf5_kind<typename N::Kind>);
    values.resize(n);
    for (std::size_t k = 0; k < n; ++k) N::get(rows.data() + k * N::count, values[k]);
  }

  template <class T, class A>
  void list(const std::string& name, std::vector<T, A>& values) {
    if constexpr (IsNumbers<T>) {
      numbers(name, values);
    } else if constexpr (std::is_same_v<T, std::string>) {
      values = file_.read_texts(group_ + name);
    } else {
      ArchiveReader inner = inside(name);
      std::int64_t size = 0;
      inner("size", size);
      values.assign(static_cast<std::size_t>(size), T{});
      if constexpr (is_row<T>) {
        if (size > 0) inner.rows(values);
      } else {
        for (std::size_t k = 0; k < values.size(); ++k) inner(std::to_string(k), values[k]);
      }
    }
  }

  /// The columns a row asks for are those the first value would write.
  template <class T>
  void rows(std::vector<T>& values) {
    ArchiveColumns columns;
    RowWriter asked{columns};
    fields(asked, std::as_const(values.front()));
    for (auto& [key, column] : columns.numbers) {
      const std::size_t n = file_.rows(group_ + key, column.kind, column.width);
      require(n == values.size(), "\"{}\" has {} rows in place of {}", group_ + key, n, values.size());
      column.bytes.resize(column.bytes.size() * n);
      file_.read(group_ + key, column.bytes.data(), column.kind);
    }
    for (auto& [key, texts] : columns.texts) texts = file_.read_texts(group_ + key);
    for (std::size_t k = 0; k < values.size(); ++k) {
      RowReader row{columns, k};
      fields(row, values[k]);
    }
  }

  const Hdf5File& file_;
  std::string group_;
};

}  // namespace puadem
