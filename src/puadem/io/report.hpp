#pragma once

#include <string>
#include <string_view>

#include "puadem/io/results_folder.hpp"

namespace puadem {

/// The report of a run: one HTML page that holds its data, style and script and asks no server for
/// anything. Overlays of the case are read from their folders; one that cannot be read becomes a
/// warning on the page.
std::string report_html(const ResultsFolder& folder, const Case& c, const State& state, const RunResults* results, int exit_code,
                        const std::string& error_message);

/// Text as HTML content: no character of it is taken for markup.
std::string escape_html(std::string_view text);

/// JSON that may stand inside a script element: no '<' is left in it.
std::string escape_script(std::string json);

}  // namespace puadem
