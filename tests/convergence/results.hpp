#pragma once

// What a run of the convergence test leaves for tools/convergence.py: numbers, and pictures side by side.

#include "rows.hpp"

namespace velarium::test {

// Below VELARIUM_CONVERGENCE_OUT, or else below the working folder.
[[nodiscard]] std::filesystem::path results_folder();

// NAME.json: the errors. NAME.jpg: the picture, its reference, and FLIP of each pixel.
void write_results(const Row& row, const Picture& picture, const Picture& reference, const Comparison& comparison);

}  // namespace velarium::test
