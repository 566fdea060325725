#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "doctor.hpp"
#include "puadem/base/error.hpp"
#include "puadem/base/parallel.hpp"
#include "puadem/io/case_file.hpp"
#include "puadem/io/case_summary.hpp"
#include "puadem/io/case_templates.hpp"
#include "puadem/io/compare.hpp"
#include "puadem/io/convert.hpp"
#include "puadem/io/initial_state.hpp"
#include "puadem/io/inspect.hpp"
#include "puadem/io/manifest.hpp"
#include "puadem/io/progress_line.hpp"
#include "puadem/io/results_folder.hpp"
#include "puadem/io/resume.hpp"
#include "puadem/io/run_summary.hpp"
#include "puadem/io/text.hpp"

namespace puadem {

namespace {

namespace fs = std::filesystem;

enum ExitCode { ok = 0, wrong_input = 1, physics_stopped = 2, interrupted = 3, internal_error = 4 };

volatile std::sig_atomic_t stop_requested = 0;

/// The first signal asks the run to stop at a safe place, the second one ends the program.
void request_stop(int signal) {
  stop_requested = 1;
  std::signal(signal, SIG_DFL);
}

struct RunOptions {
  std::string case_file;
  std::vector<std::string> overrides;
  std::string output;
  int threads = 0;
  bool quiet = false;
  bool json = false;
  double time_limit = 0.0;  // [s]; 0: none
};

void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) fmt::print(stderr, "warning: {}\n", warning);
}

/// "drainage-beads" for drainage-beads/case.toml, "drainage-beads-tiny" for drainage-beads/tiny.toml.
std::string name_of(const fs::path& case_file) {
  const fs::path path = fs::absolute(case_file).lexically_normal();
  const std::string folder = path.parent_path().filename().string(), stem = path.stem().string();
  if (stem == "case" && !folder.empty()) return folder;
  return folder.empty() ? stem : fmt::format("{}-{}", folder, stem);
}

/// Case text for the results folder, with the overrides it was run with.
std::string text_with_overrides(const CaseFile& file, const std::vector<std::string>& overrides) {
  std::string text = file.text;
  if (!overrides.empty() && !text.ends_with('\n')) text += '\n';
  for (const std::string& assignment : overrides) text += fmt::format("# run with --set {}\n", assignment);
  return text;
}

Observer combined(const Observer& recorder, ProgressLine& line, const RunOptions& options) {
  const auto began = ProgressLine::Clock::now();
  const double limit = options.time_limit > 0.0 ? options.time_limit : std::numeric_limits<double>::infinity();
  const bool quiet = options.quiet;
  Observer observer = recorder;
  observer.progress = [&recorder, &line, quiet, began, limit](const Progress& progress) {
    const bool go_on = recorder.progress(progress);
    if (!quiet) line.show(progress);
    const std::chrono::duration<double> taken = ProgressLine::Clock::now() - began;
    return go_on && stop_requested == 0 && taken.count() < limit;
  };
  observer.message = [&recorder, &line, quiet](std::string_view text) {
    recorder.message(text);
    if (!quiet) line.message(text);
  };
  return observer;
}

/// Runs the stages; what went wrong ends up in the outcome.
RunResults run_stages(const Case& c, State& state, const Observer& observer, RunResults results, ResultsFolder& folder,
                      RunOutcome& outcome) {
  try {
    results = run(c, state, observer, std::move(results));
    const auto missed = missed_bounds(c, results);
    if (results.interrupted) {
      outcome.exit_code = interrupted;
      outcome.error = "interrupted";
    } else if (!missed.empty()) {
      outcome.exit_code = physics_stopped;
      outcome.error = summarised("results outside the bounds of [expected]:", missed);
    }
  } catch (const InputError& error) {
    outcome.exit_code = wrong_input;
    outcome.error = error.what();
  } catch (const NumericalError& error) {
    outcome.exit_code = physics_stopped;
    outcome.error = error.what();
    if (record_safe_place(folder, c))
      outcome.error += fmt::format("; the last safe place before is kept: puadem resume {}", folder.path.string());
  } catch (const std::bad_alloc&) {
    outcome.exit_code = physics_stopped;
    outcome.error = "out of memory; try fewer grains (grains.count)";
  }
  return results;
}

/// Threads worth starting: a thread with few grains waits for the others at the end of every step, long where
/// another program has its core.
int useful_threads(int grains) {
  constexpr int grains_of_a_thread = 5000;
  return std::clamp(grains / grains_of_a_thread, 1, threads());
}

/// Runs the stages that are left and writes what they found.
int run_to_end(const Case& c, State& state, RunResults results, ResultsFolder& folder, const RunOptions& options) {
  const auto began = ProgressLine::Clock::now();
  set_threads(options.threads > 0 ? options.threads : useful_threads(std::max(state.particles.size(), c.grains.count)));
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);

  RunOutcome outcome;
  outcome.folder = folder.path;
  const Observer recorder = recording_observer(folder, c);
  {
    ProgressLine line(stderr);
    results = run_stages(c, state, combined(recorder, line, options), std::move(results), folder, outcome);
  }
  if (outcome.exit_code != interrupted && !outcome.error.empty()) fmt::print(stderr, "error: {}\n", outcome.error);
  finish_results(folder, c, state, &results, outcome.exit_code, outcome.error);
  std::error_code failed;
  if (!fs::exists(outcome.folder, failed)) outcome.folder.clear();
  if (outcome.exit_code == interrupted) {
    const bool can_go_on = !outcome.folder.empty() && fs::exists(outcome.folder / "checkpoints", failed);
    fmt::print(stderr, "interrupted{}\n",
               outcome.folder.empty() ? " before the first result; nothing is kept"
               : can_go_on            ? fmt::format("; go on with: puadem resume {}", outcome.folder.string())
                                      : "; what was finished is kept");
  }
  outcome.wall_time = std::chrono::duration<double>(ProgressLine::Clock::now() - began).count();
  if (options.json)
    fmt::print("{}", run_json(c, state, results, outcome));
  else if (!options.quiet)
    fmt::print("{}", run_text(c, state, results, outcome));
  return outcome.exit_code;
}

int run_case(const RunOptions& options) {
  CaseFile file = read_case(options.case_file, options.overrides);
  State state = initial_state(file.c, file.warnings);
  if (!options.quiet) print_warnings(file.warnings);
  std::optional<fs::path> output;
  if (!options.output.empty()) output = options.output;
  ResultsFolder folder = open_results(file.c, text_with_overrides(file, options.overrides), resolved_case(file.c), output,
                                      name_of(options.case_file));
  folder.warnings.insert(folder.warnings.end(), file.warnings.begin(), file.warnings.end());
  return run_to_end(file.c, state, {}, folder, options);
}

int resume(const RunOptions& options, const std::string& from) {
  std::optional<fs::path> checkpoint, output;
  if (!from.empty()) checkpoint = from;
  if (!options.output.empty()) output = options.output;
  Resumed r = resume_run(options.case_file, checkpoint, output);
  if (!options.quiet) fmt::print(stderr, "going on from {}\n", r.checkpoint.string());
  return run_to_end(r.c, r.state, std::move(r.results), r.folder, options);
}

int check(const RunOptions& options) {
  const CaseFile file = read_case(options.case_file, options.overrides);
  const CaseSummary summary = summarise_case(file.c);
  fmt::print("{}", summary.text);
  std::fflush(stdout);
  print_warnings(file.warnings);
  print_warnings(summary.warnings);
  const std::size_t warnings = file.warnings.size() + summary.warnings.size();
  fmt::print("{}: the case is right{}\n", options.case_file,
             warnings == 0 ? "" : fmt::format(", with {} warning{}", warnings, warnings == 1 ? "" : "s"));
  return ok;
}

struct ConvertArguments {
  std::string in, out, to, inlet = "left", merge_ratio = "0.9";
  std::vector<std::string> periodic;
};

/// Index of a word among those allowed.
std::size_t index_of(std::string_view flag, const std::string& word, const std::vector<std::string>& allowed) {
  const auto found = std::find(allowed.begin(), allowed.end(), word);
  if (found == allowed.end())
    throw InputError(
        fmt::format("{} \"{}\" is not known; allowed: {}{}", flag, word, joined(allowed), did_you_mean(word, allowed)));
  return static_cast<std::size_t>(found - allowed.begin());
}

int convert_file(const ConvertArguments& arguments) {
  ConvertOptions options;
  if (!arguments.to.empty())
    options.target = static_cast<ConvertOptions::Target>(1 + index_of("--to", arguments.to, {"packing", "network", "statoil"}));
  options.inlet = static_cast<int>(index_of("--inlet", arguments.inlet, {face_names.begin(), face_names.end()}));
  for (const std::string& axis : arguments.periodic) options.periodic[index_of("--periodic", axis, {"x", "y", "z"})] = true;
  options.merge_ratio = std::numeric_limits<double>::infinity();
  if (arguments.merge_ratio != "none") {
    char* end = nullptr;
    options.merge_ratio = std::strtod(arguments.merge_ratio.c_str(), &end);
    if (*end != '\0' || !(options.merge_ratio > 0.0))
      throw InputError(fmt::format("--merge-ratio \"{}\" must be a number > 0, or none", arguments.merge_ratio));
  }
  fmt::print("{}", convert(arguments.in, arguments.out, options));
  return ok;
}

/// Flags of a verb and those of the program.
std::vector<std::string> flag_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// Message for a command line that could not be read.
std::string usage_error(const CLI::App& app, const CLI::ParseError& error, const std::vector<std::string>& arguments) {
  std::vector<std::string> verbs;
  for (const CLI::App* verb : app.get_subcommands({})) verbs.push_back(verb->get_name());
  if (!arguments.empty() && !arguments[0].starts_with('-') && std::find(verbs.begin(), verbs.end(), arguments[0]) == verbs.end())
    return fmt::format("unknown verb \"{}\"{}; verbs: {}", arguments[0], did_you_mean(arguments[0], verbs), joined(verbs));
  const CLI::App* verb = app.get_subcommands().empty() ? &app : app.get_subcommands().front();
  const std::vector<std::string> flags = flag_names(*verb);
  for (const std::string& argument : arguments) {
    const std::string flag = argument.substr(0, argument.find('='));
    if (flag.starts_with("--") && std::find(flags.begin(), flags.end(), flag) == flags.end())
      return fmt::format("unknown flag {}{}; flags: {}", flag, did_you_mean(flag, flags), joined(flags));
  }
  return fmt::format("{}; see puadem {}--help", error.what(), verb == &app ? "" : verb->get_name() + " ");
}

int compare_runs(const std::string& first, const std::string& second, const std::string& table) {
  require(table.empty() || !fs::exists(table), "{} exists already", table);
  const Comparison comparison = compare(first, second);
  fmt::print("{}", comparison_text(comparison));
  if (!table.empty()) write_file(table, comparison_csv(comparison));
  return ok;
}

int dispatch(int argc, char** argv) {
  CLI::App app{"Granular media with two fluids in their pores, grain by grain and pore by pore.", "puadem"};
  app.require_subcommand(1);
  app.set_version_flag("--version", version_text());
  app.footer(
      "Exit codes: 0 ok, 1 wrong input, 2 the physics stopped or [expected] failed, 3 interrupted but resumable, 4 internal "
      "error.");

  RunOptions options;
  std::string name, target, word, path, checkpoint;
  bool markdown = false;
  CLI::App* new_verb = app.add_subcommand("new", "start from a shipped case");
  new_verb->add_option("template", name, "name of the case; none: list them");
  new_verb->add_option("folder", target, "new folder; none: named as the template");

  CLI::App* check_verb = app.add_subcommand("check", "say what a case will do, without running it");
  CLI::App* run_verb = app.add_subcommand("run", "run all stages of a case");
  for (CLI::App* verb : {check_verb, run_verb}) {
    verb->add_option("case", options.case_file, "case file")->required();
    verb->add_option("--set", options.overrides,
                     "KEY=VALUE in place of the file's value, such as grains.count=500; may be repeated")
        ->expected(1)
        ->take_all();
  }
  run_verb->add_option("--output", options.output, "folder for the results; none: a new one in runs/");
  CLI::App* resume_verb = app.add_subcommand("resume", "go on with a run that was stopped, from its last checkpoint");
  resume_verb->add_option("run", options.case_file, "folder of the run")->required();
  resume_verb->add_option("--from", checkpoint, "one of its checkpoints in place of the last");
  resume_verb->add_option("--output", options.output, "new folder: go on in a copy; none: in the folder itself");
  for (CLI::App* verb : {run_verb, resume_verb}) {
    verb->add_option(
            "--threads", options.threads,
            "number of threads; default: one for every 5,000 grains, as far as the machine has them. Results do not depend on it")
        ->check(CLI::Range(0, 4096));
    verb->add_option("--time-limit", options.time_limit, "seconds of wall time after which the run writes a checkpoint and stops")
        ->check(CLI::PositiveNumber);
    verb->add_flag("--quiet", options.quiet, "print errors only");
    verb->add_flag("--json", options.json, "print the results as JSON");
  }

  CLI::App* keys_verb = app.add_subcommand("keys", "describe the keys of a case file");
  keys_verb->add_option("word", word, "only keys whose name or help has this word");
  keys_verb->add_flag("--markdown", markdown, "as docs/case_file.md");
  CLI::App* info_verb = app.add_subcommand("info", "describe a packing, a network, a case or a run");
  info_verb->add_option("file", path, "packing or network, case.toml or run folder")->required();
  ConvertArguments conversion;
  CLI::App* convert_verb = app.add_subcommand("convert", "write a packing or a network in another form");
  convert_verb->add_option("in", conversion.in, "packing or network (.csv), names of Statoil's four files, or run folder")
      ->required();
  convert_verb->add_option("out", conversion.out, "new file: NAME.csv, or NAME for Statoil's four files")->required();
  convert_verb->add_option("--to", conversion.to, "packing, network (a table) or statoil; default: by the name");
  convert_verb->add_option("--inlet", conversion.inlet, "face where the flow of Statoil's network begins; default: left");
  convert_verb->add_option("--periodic", conversion.periodic, "axes of a packing without walls, such as x,y; default: none")
      ->delimiter(',');
  convert_verb->add_option("--merge-ratio", conversion.merge_ratio,
                           "of the pores of a packing, or none; default: 0.9. A run folder brings the options of its case");
  std::string first_run, second_run, side_by_side;
  CLI::App* compare_verb = app.add_subcommand("compare", "set the curves and results of two runs beside each other");
  compare_verb->add_option("first", first_run, "run folder, or a table (.csv)")->required();
  compare_verb->add_option("second", second_run, "the other; a table is compared by the names of its columns")->required();
  compare_verb->add_option("--table", side_by_side, "new file with all curves side by side (.csv)");
  CLI::App* version_verb = app.add_subcommand("version", "print the version");
  CLI::App* doctor_verb = app.add_subcommand("doctor", "look whether all that a run needs is there");

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::CallForVersion& version) {
    return app.exit(version);
  } catch (const CLI::ParseError& error) {
    throw InputError(usage_error(app, error, {argv + 1, argv + argc}));
  }

  if (new_verb->parsed()) {
    if (name.empty())
      fmt::print("{}\n", joined(case_templates(), "\n"));
    else
      fmt::print("{0}: a new case; try: puadem check {0}/case.toml\n", new_case(name, target).string());
    return ok;
  }
  if (check_verb->parsed()) return check(options);
  if (run_verb->parsed()) return run_case(options);
  if (resume_verb->parsed()) return resume(options, checkpoint);
  if (keys_verb->parsed()) fmt::print("{}", markdown ? keys_markdown() : keys_text(word));
  if (info_verb->parsed()) fmt::print("{}", inspect(path));
  if (convert_verb->parsed()) return convert_file(conversion);
  if (compare_verb->parsed()) return compare_runs(first_run, second_run, side_by_side);
  if (version_verb->parsed()) fmt::print("{}\n", version_text());
  if (doctor_verb->parsed()) return doctor() ? ok : wrong_input;
  return ok;
}

}  // namespace

}  // namespace puadem

int main(int argc, char** argv) {
  using namespace puadem;
  try {
    return dispatch(argc, argv);
  } catch (const InputError& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return wrong_input;
  } catch (const NumericalError& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return physics_stopped;
  } catch (const std::exception& error) {
    fmt::print(
        stderr,
        "internal error: {}\nThis is a fault of puadem: please report it with the case file and the output of `puadem doctor`.\n",
        error.what());
    return internal_error;
  }
}
