#pragma once

#include <string_view>

#include "puadem/io/results_folder.hpp"

namespace puadem {

// What the parts of the recording observer share.

/// The series `file`, opened with its header when first needed.
AppendFile& series(const ResultsFolder& folder, AppendFile& file, const char* name, std::string_view header);

/// A line of the log; one that begins with "warning: " goes into the manifest and the report too.
void record_message(ResultsFolder& folder, std::string_view message);

/// The next file of a series of fields, and the series itself.
void write_frame(const ResultsFolder& folder, std::vector<VtkFrame>& frames, const char* name, double time,
                 const VtkPolyData& data);

/// Adds what a stage "two-phase-flow" tells. Folder and case must outlive the observer.
void record_two_phase(ResultsFolder& folder, const Case& c, Observer& observer);

/// Adds what stages "saturated-flow" and "unsaturated-flow" tell. Folder and case must outlive the observer.
void record_coupled(ResultsFolder& folder, const Case& c, Observer& observer);

/// series/haines_jump.csv and series/boxes.csv of every such stage; from the second on their names end in the stage's.
void write_flow_records(const ResultsFolder& folder, const State& state);

}  // namespace puadem
