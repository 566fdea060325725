#include "puadem/io/case_schema.hpp"
#include "puadem/io/key_builders.hpp"

namespace puadem {

Field<Case> network_field() {
  static const Section<Case> section{{bind<Case>(
      needed(
          plain("file", "a path",
                "a network in place of grains: a table of pores and throats (.csv), or the common beginning of the four files of "
                "Statoil's format, relative to the case file",
                R"("rock.csv")")),
      &Case::network_file)}};
  Field<Case> field;
  field.info = plain("network", "a table", "a pore network from a file, in place of grains");
  field.read = [](const TomlValue& value, Problems& problems, Case& c) { read_table(value, section, problems, c); };
  field.write_tables = [](const std::string& path, const Case& c) {
    return c.network_file ? "\n[" + path + "]\n" + write_table(path, section, c) : std::string();
  };
  field.describe = [](const std::string& path, std::vector<KeyDoc>& out) { describe_table(path, section, out); };
  return field;
}

Field<Case> only_with_grains(Field<Case> field) {
  field.write_tables = [write = field.write_tables](const std::string& path, const Case& c) {
    return c.network_file ? std::string() : write(path, c);
  };
  return field;
}

Field<Case> pores_field() {
  Field<Case> field = bind_table<Case>(plain("pores", "a table", "the pore network"), pores_section, &Case::pores);
  field.write_tables = [](const std::string& path, const Case& c) {
    const Section<PoreOptions> bounds{{pores_section().fields.back()}};
    const std::string text = write_table(path, c.network_file ? bounds : pores_section(), c.pores);
    return text.empty() ? text : "\n[" + path + "]\n" + text;
  };
  return field;
}

}  // namespace puadem
