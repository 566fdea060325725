#include "puadem/io/series_writer.hpp"

#include <charconv>
#include <map>

#include "puadem/base/error.hpp"
#include "puadem/io/text_file.hpp"

namespace puadem {
namespace {

/// A CSV file as columns found by name. Fields are plain: our series quote nothing.
class Table {
 public:
  explicit Table(const std::filesystem::path& path) : path_(path.string()) {
    const std::string text = read_text_file(path);
    int number = 0;
    for (std::size_t at = 0; at < text.size();) {
      std::size_t end = std::min(text.find('\n', at), text.size());
      std::string line = text.substr(at, end - at);
      at = end + 1;
      ++number;
      if (!line.empty() && line.back() == '\r') line.pop_back();
      if (line.empty() || line.front() == '#') continue;
      std::vector<std::string> fields = split(line);
      if (columns_.empty()) {
        for (int k = 0; k < size_of(fields); ++k) columns_[fields[to_size(k)]] = k;
        width_ = size_of(fields);
      } else {
        require(size_of(fields) == width_, "{}:{}: {} fields where the header names {}", path_, number, fields.size(), width_);
        rows_.push_back({number, std::move(fields)});
      }
    }
    require(!columns_.empty(), "{}: no header line", path_);
  }

  int rows() const { return size_of(rows_); }
  bool has(const std::string& column) const { return columns_.contains(column); }

  const std::string& text(int row, const std::string& column) const {
    const auto found = columns_.find(column);
    require(found != columns_.end(), "{}: no column '{}'", path_, column);
    return rows_[to_size(row)].fields[to_size(found->second)];
  }

  double number(int row, const std::string& column) const {
    const std::string& field = text(row, column);
    double value = 0.0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    require(error == std::errc{} && end == field.data() + field.size(), "{}:{}: '{}' in column '{}' is not a number", path_,
            rows_[to_size(row)].number, field, column);
    return value;
  }

  double number_or(int row, const std::string& column, double absent) const { return has(column) ? number(row, column) : absent; }

 private:
  struct Row {
    int number;
    std::vector<std::string> fields;
  };

  static std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> fields(1);
    for (const char c : line)
      if (c == ',')
        fields.emplace_back();
      else
        fields.back() += c;
    return fields;
  }

  std::string path_;
  std::map<std::string, int> columns_;
  int width_ = 0;
  std::vector<Row> rows_;
};

void append_bins(std::string& csv, std::string_view kind, const std::vector<Bin>& bins) {
  for (const Bin& b : bins) csv += fmt::format("{},{},{},{}\n", kind, b.low, b.high, b.density);
}

constexpr const char* bridge_columns =
    ",bridges,bridges_per_grain,water_bridges_m3,water_films_m3,water_error,force_bridge_mean_N,force_contact_mean_N,"
    "sigma_bridges_xx_Pa,sigma_bridges_yy_Pa,sigma_bridges_zz_Pa,p_bridges_Pa,bridges_formed,bridges_ruptured,energy_bridges_J,"
    "loss_wetting_J";

}  // namespace

std::string retention_line(const RetentionRow& r) {
  return fmt::format("{},{},{},{},{},{},{}\n", r.step, r.branch, r.capillary_pressure, r.pc_star, r.saturation, r.trapped_wetting,
                     r.trapped_nonwetting);
}

std::string history_header(const Domain& domain, bool has_bridges) {
  std::string header =
      "time_s,stage,step,time_step_s,strain_xx,strain_yy,strain_zz,strain_volumetric,porosity,void_ratio,sigma_xx_Pa,sigma_yy_Pa,"
      "sigma_zz_Pa,p_Pa,q_Pa,shear_strain,normal_stress_Pa,shear_stress_Pa,unbalanced,coordination,coordination_inner,"
      "coordination_"
      "mechanical,rattlers,sliding,fabric_anisotropy,largest_overlap";
  for (int face = 0; face < 6; ++face)
    if (domain.is_wall(face)) {
      const std::string_view name = face_names[to_size(face)];
      header += fmt::format(",force_{0}_x_N,force_{0}_y_N,force_{0}_z_N,position_{0}_m", name);
    }
  return header +
         ",energy_kinetic_J,energy_normal_J,energy_shear_J,loss_friction_J,work_shear_J,work_rolling_J,loss_viscous_J,"
         "loss_damping_J,work_input_J,energy_residual_J" +
         (has_bridges ? bridge_columns : "") + "\n";
}

std::string history_line(const HistoryRow& r, const Domain& domain) {
  std::string line = fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}", r.time, r.stage,
                                 r.step, r.time_step, r.strain.x, r.strain.y, r.strain.z, r.volumetric, r.porosity,
                                 r.void_ratio(), r.stress.x, r.stress.y, r.stress.z, r.mean, r.deviator, r.shear_strain,
                                 r.normal_stress, r.shear_stress, r.unbalanced, r.coordination, r.coordination_inner,
                                 r.coordination_mechanical, r.rattlers, r.sliding, r.fabric_anisotropy, r.largest_overlap);
  for (int face = 0; face < 6; ++face)
    if (domain.is_wall(face)) {
      const Vec3& f = r.wall_force[to_size(face)];
      line += fmt::format(",{},{},{},{}", f.x, f.y, f.z, r.wall_position[to_size(face)]);
    }
  const Energies& e = r.energy;
  line += fmt::format(",{},{},{},{},{},{},{},{},{},{}", e.kinetic, e.normal, e.shear, e.friction, e.shear_work, e.roll_work,
                      e.viscous, e.damping, e.input, r.energy_residual);
  if (r.bridges) {
    const BridgeRow& b = *r.bridges;
    line += fmt::format(",{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}", b.bridges, b.coordination, b.water, b.film,
                        b.water_error, b.mean_force, b.mean_contact_force, b.stress.x, b.stress.y, b.stress.z, b.mean_stress,
                        b.formed, b.ruptured, e.bridges, e.wetting);
  }
  return line + "\n";
}

std::string event_line(long event, const InvasionEvent& e) {
  return fmt::format("{},{},{},{},{},{},{}\n", event, event_name(e.kind), e.capillary_pressure, e.pore, e.throat, e.units,
                     e.wetting_volume);
}

std::string compaction_line(const Progress& p) {
  return fmt::format("{},{},{},{}\n", p.step, p.porosity, p.stress, p.unbalanced);
}

std::string pressure_line(const PermeabilityResult& result, const PressureLayer& layer) {
  return fmt::format("{},{},{},{},{}\n", result.stage, layer.place, layer.pressure, layer.linear, layer.pores);
}

std::string distributions_csv(const RadiusDistributions& d) {
  std::string csv(distributions_header);
  append_bins(csv, "pore", d.pore);
  append_bins(csv, "throat", d.throat);
  return csv;
}

std::vector<RetentionRow> read_retention(const std::filesystem::path& path) {
  const Table table(path);
  std::vector<RetentionRow> rows;
  for (int k = 0; k < table.rows(); ++k) {
    RetentionRow row;
    row.step = static_cast<int>(table.number_or(k, "step", k));
    row.branch = table.has("branch") ? table.text(k, "branch") : "data";
    row.capillary_pressure = table.number(k, "pc_Pa");
    row.pc_star = table.number_or(k, "pc_star", 0.0);
    row.saturation = table.number(k, "saturation");
    row.trapped_wetting = table.number_or(k, "trapped_wetting", 0.0);
    row.trapped_nonwetting = table.number_or(k, "trapped_nonwetting", 0.0);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<HistoryRow> read_history(const std::filesystem::path& path) {
  const Table table(path);
  std::vector<HistoryRow> rows;
  for (int k = 0; k < table.rows(); ++k) {
    HistoryRow row;
    row.stage = table.has("stage") ? table.text(k, "stage") : "triaxial";
    row.time = table.number_or(k, "time_s", 0.0);
    row.strain.z = table.number(k, "strain_zz");
    row.volumetric = table.number_or(k, "strain_volumetric", 0.0);
    row.porosity = table.number_or(k, "porosity", 0.0);
    row.mean = table.number(k, "p_Pa");
    row.deviator = table.number(k, "q_Pa");
    row.stress.z = table.number_or(k, "sigma_zz_Pa", row.mean + 2.0 / 3.0 * row.deviator);
    row.shear_strain = table.number_or(k, "shear_strain", 0.0);
    row.normal_stress = table.number_or(k, "normal_stress_Pa", 0.0);
    row.shear_stress = table.number_or(k, "shear_stress_Pa", 0.0);
    row.coordination = table.number_or(k, "coordination", 0.0);
    row.unbalanced = table.number_or(k, "unbalanced", 0.0);
    rows.push_back(std::move(row));
  }
  return rows;
}

RadiusDistributions read_distributions(const std::filesystem::path& path) {
  const Table table(path);
  RadiusDistributions d;
  for (int k = 0; k < table.rows(); ++k) {
    const std::string& kind = table.text(k, "kind");
    require(kind == "pore" || kind == "throat", "{}: kind '{}' is neither 'pore' nor 'throat'", path.string(), kind);
    (kind == "pore" ? d.pore : d.throat)
        .push_back({table.number(k, "bin_low"), table.number(k, "bin_high"), table.number(k, "pdf")});
  }
  return d;
}

}  // namespace puadem
