#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "puadem/base/error.hpp"
#include "puadem/coupling/checked_network.hpp"
#include "puadem/coupling/run.hpp"
#include "puadem/io/case_file.hpp"
#include "puadem/io/case_summary.hpp"
#include "puadem/io/convert.hpp"
#include "puadem/io/initial_state.hpp"
#include "puadem/io/inspect.hpp"
#include "puadem/io/network_file.hpp"
#include "puadem/io/packing_file.hpp"
#include "support/packings.hpp"
#include "support/temporary_folder.hpp"

using namespace puadem;
using namespace puadem::testing;
using ::testing::HasSubstr;

namespace {

/// A packing file in a folder of its own, between six walls.
struct Study {
  TemporaryFolder folder;
  Spheres spheres = random_spheres(300, 1.4, {6e-3, 6e-3, 6e-3}, {false, false, false}, 11, 0.33);

  Study() { write_packing(at("packing.csv"), spheres.centre, spheres.radius, spheres.domain); }
  std::filesystem::path at(const char* name) const { return folder.path / name; }
  Case read(const std::string& text) const { return parse_case(text, "case.toml", folder.path).c; }
  std::string error_of(const std::string& text) const {
    try {
      std::vector<std::string> warnings;
      initial_state(read(text), warnings);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }
};

struct Ran {
  State state;
  RunResults results;
};

Ran run_of(const Case& c) {
  std::vector<std::string> warnings;
  Ran ran{initial_state(c, warnings), {}};
  ran.results = run(c, ran.state, {});
  return ran;
}

const std::string stages = R"(
[[stage]]
kind = "permeability"
merged = true
[[stage]]
kind = "retention"
wall_throats = false
path = ["50 Pa", "1500 Pa", "0 Pa"]
step = "50 Pa"
)";
std::string without(std::string text, const std::string& part) { return text.erase(text.find(part), part.size()); }

}  // namespace

TEST(NetworkCase, ATableGivesThePermeabilityAndTheCurveOfItsPacking) {
  const Study study;
  const std::string fluids = "[fluids]\ncontact_angle = \"20 deg\"\n";
  const Case packing = study.read("[grains]\nfile = \"packing.csv\"\n" + fluids + stages);
  const Ran own = run_of(packing);
  write_csv_network(study.at("rock.csv"), own.state.network, own.state.domain, packing.fluids.contact_angle);

  const Case c = study.read("[network]\nfile = \"rock.csv\"\n" + fluids + without(stages, "merged = true\n"));
  const Ran back = run_of(c);
  EXPECT_EQ(back.state.particles.size(), 0);
  EXPECT_EQ(back.state.permeability.at(0).permeability.tensor, own.state.permeability.at(0).permeability.tensor);
  EXPECT_EQ(back.state.permeability[0].linear_error, own.state.permeability[0].linear_error);
  EXPECT_NEAR(back.state.permeability[0].porosity, own.state.permeability[0].porosity, 1e-12);
  EXPECT_FALSE(back.state.permeability[0].sauter_radius);
  ASSERT_EQ(back.state.retention.size(), own.state.retention.size());
  for (std::size_t k = 0; k < own.state.retention.size(); ++k) {
    EXPECT_EQ(back.state.retention[k].saturation, own.state.retention[k].saturation) << k;
    EXPECT_EQ(back.state.retention[k].trapped_nonwetting, own.state.retention[k].trapped_nonwetting) << k;
  }
  EXPECT_LT(own.state.retention[29].saturation, 0.5);                      // it has drained
  EXPECT_FALSE(back.results.scalars.contains("pc_star_half_drainage-1"));  // no grains, no grain radius
  EXPECT_TRUE(back.results.scalars.contains("pc_half_drainage-1_Pa"));
}

TEST(NetworkCase, StatoilsFormatKeepsThePermeabilityButNotTheEntryRadii) {
  const Study study;
  const Case packing = study.read("[grains]\nfile = \"packing.csv\"\n" + without(stages, "wall_throats = false\n"));
  const Ran own = run_of(packing);
  write_statoil_network(study.at("rock"), own.state.network, own.state.domain, 5);
  const Ran back =
      run_of(study.read("[network]\nfile = \"rock\"\n[[stage]]\nkind = \"permeability\"\ninlet = \"left\"\n[[stage]]\n"
                        "kind = \"retention\"\nair = \"left\"\nwater = \"right\"\npath = [\"50 Pa\", \"1500 Pa\", \"0 Pa\"]\n"
                        "step = \"50 Pa\"\n"));
  const double k = own.results.scalars.at("permeability_zz_m2");
  EXPECT_NEAR(back.results.scalars.at("permeability_xx_m2"), k, 1e-3 * k);  // the top has become the left
  EXPECT_EQ(back.results.scalars.at("permeability_mean_m2"), back.results.scalars.at("permeability_xx_m2"));
  EXPECT_FALSE(back.results.scalars.contains("permeability_yy_m2"));
  EXPECT_NEAR(back.results.scalars.at("permeability_porosity"), own.results.scalars.at("permeability_porosity"), 1e-12);
  const double half = own.results.scalars.at("pc_half_drainage-1_Pa");
  EXPECT_NEAR(back.results.scalars.at("pc_half_drainage-1_Pa") / half, 1.0, 0.5);
}

TEST(NetworkCase, SaysWhatItCannotDo) {
  const Study study;
  const Case packing = study.read("[grains]\nfile = \"packing.csv\"\n" + stages);
  std::vector<std::string> warnings;
  const State state = initial_state(packing, warnings);
  const PoreNetwork network = checked_network(packing, state, {});
  write_csv_network(study.at("rock.csv"), network, state.domain);
  write_statoil_network(study.at("tubes"), network, state.domain, 4);
  const std::string rock = "[network]\nfile = \"rock.csv\"\n", tubes = "[network]\nfile = \"tubes\"\n",
                    flow = "[[stage]]\nkind = \"permeability\"\n", drain = "[[stage]]\nkind = \"retention\"\npath = [1, 9]\n";
  EXPECT_EQ(study.error_of(rock + flow + drain), "no error");
  EXPECT_THAT(study.error_of(flow), HasSubstr("or [network] with the file of a network"));
  EXPECT_THAT(study.error_of("[network]\n" + flow), HasSubstr("missing key network.file"));
  EXPECT_THAT(study.error_of("[network]\nfile = \"sand.csv\"\n" + flow), HasSubstr("no such file"));
  EXPECT_THAT(study.error_of("[network]\nfile = \"sand\"\n" + flow), HasSubstr("sand_node1.dat"));
  EXPECT_THAT(study.error_of("[network]\nfile = \"packing.csv\"\n" + flow), HasSubstr("a packing is named by grains.file"));
  EXPECT_THAT(study.error_of(rock + "[grains]\nfile = \"packing.csv\"\n" + flow),
              HasSubstr("grains is not used with network.file"));
  EXPECT_THAT(study.error_of(rock + "[domain]\nperiodic = [\"x\"]\n" + flow), HasSubstr("domain is not used with network.file"));
  EXPECT_THAT(study.error_of(rock + "[pores]\nmerge_ratio = 0.9\n" + flow), HasSubstr("pores.merge_ratio is not used"));
  EXPECT_EQ(study.error_of(rock + "[pores]\nconductance_limits = [0.1, 10]\n" + flow), "no error");
  EXPECT_THAT(study.error_of(rock + flow + "merged = true\n"), HasSubstr("stage.0.merged is not used with network.file"));
  EXPECT_THAT(study.error_of(rock + "[[stage]]\nkind = \"compact\"\nstress = 100\n"),
              HasSubstr("a stage \"compact\" needs grains"));
  EXPECT_THAT(study.error_of(rock + "[[stage]]\nkind = \"triaxial\"\nstress = 100\n"),
              HasSubstr("a stage \"triaxial\" needs grains"));
  EXPECT_THAT(study.error_of(tubes + flow), HasSubstr("lies at the top face; its pores lie at: left, right"));
  EXPECT_THAT(study.error_of(tubes + drain), HasSubstr("stage.0.air: no pore of"));
  EXPECT_THAT(study.error_of(tubes + drain + "air = \"left\"\nwater = \"right\"\nwall_throats = false\n"),
              HasSubstr("does not tell which throats lie along walls"));
  EXPECT_THAT(study.error_of(rock + "[fluids]\ncontact_angle = \"30 deg\"\n" + drain),
              HasSubstr("write contact_angle = \"0 deg\""));
  EXPECT_EQ(study.error_of(rock + "[fluids]\ncontact_angle = \"30 deg\"\n" + flow), "no error");
}

TEST(NetworkCase, ReadsBackAndIsSummarised) {
  const Study study;
  const Case packing = study.read("[grains]\nfile = \"packing.csv\"\n" + stages);
  std::vector<std::string> warnings;
  const State state = initial_state(packing, warnings);
  write_csv_network(study.at("rock.csv"), checked_network(packing, state, {}), state.domain);
  const Case c = study.read("[network]\nfile = \"rock.csv\"\n[pores]\nconductance_limits = [0.1, 10]\n" +
                            without(stages, "merged = true\n"));
  const std::string resolved = resolved_case(c);
  const Case back = parse_case(resolved, "resolved", "/elsewhere").c;
  EXPECT_EQ(back.network_file, c.network_file);
  EXPECT_EQ(resolved_case(back), resolved);
  EXPECT_THAT(summarise_case(c).text, HasSubstr("pores at the faces left, right, front, back, bottom, top"));
  EXPECT_THAT(inspect(study.at("rock.csv")), HasSubstr("throats"));
}

TEST(Convert, GoesBetweenTheForms) {
  const Study study;
  ConvertOptions options;
  options.target = ConvertOptions::Target::network;
  EXPECT_THAT(convert(study.at("packing.csv"), study.at("rock.csv"), options), HasSubstr("throats"));
  const NetworkFile rock = read_network(study.at("rock.csv"));
  // As a case with the same options makes it.
  std::vector<std::string> warnings;
  const Case c = study.read("[grains]\nfile = \"packing.csv\"\n" + stages);
  EXPECT_EQ(rock.network.throat_entry_radius, checked_network(c, initial_state(c, warnings), {}).throat_entry_radius);

  options.target = ConvertOptions::Target::by_name;
  options.inlet = 2;
  EXPECT_THAT(convert(study.at("rock.csv"), study.at("tubes"), options), HasSubstr("from front to back"));
  options.inlet = 0;
  convert(study.at("tubes_link1.dat"), study.at("back.csv"), options);
  const NetworkFile back = read_network(study.at("back.csv"));
  EXPECT_EQ(back.network.pores(), rock.network.pores() + 2);
  const double k = measure_permeability(rock.network, rock.box).tensor[1].y;
  EXPECT_NEAR(measure_permeability(back.network, back.box).tensor[0].x, k, 1e-3 * k);
  EXPECT_THAT(inspect(study.at("tubes")), HasSubstr("left, right"));

  options.target = ConvertOptions::Target::packing;
  convert(study.at("packing.csv"), study.at("copy.csv"), options);
  EXPECT_EQ(read_packing(study.at("copy.csv")).centre, read_packing(study.at("packing.csv")).centre);
}

TEST(Convert, SaysWhatItCannotDo) {
  const Study study;
  const auto error_of = [&](const char* in, const char* out, const ConvertOptions& options = {}) -> std::string {
    try {
      convert(study.at(in), study.at(out), options);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(error_of("packing.csv", "other.csv"), HasSubstr("write --to packing or --to network"));
  EXPECT_THAT(error_of("packing.csv", "other.txt"), HasSubstr("the ending .txt is not known"));
  EXPECT_THAT(error_of("nothing", "other.csv"), HasSubstr("no such file"));
  EXPECT_THAT(error_of(".", "other.csv"), HasSubstr("no run of puadem"));
  EXPECT_EQ(error_of("packing.csv", "tubes"), "no error");
  EXPECT_THAT(error_of("packing.csv", "tubes"), HasSubstr("exists already"));
  EXPECT_THAT(error_of("tubes", "grains.csv", {.target = ConvertOptions::Target::packing}),
              HasSubstr("does not tell where its grains are"));
  EXPECT_THAT(error_of("packing.csv", "wrapped", {.periodic = {true, true, false}}), HasSubstr("periodic"));
}
