#pragma once

#include <cstddef>
#include <functional>

namespace velarium {

// Calls `body(i)` for every i in [0, count) on all cores and returns when all are done. Order is unspecified.
// The first exception that a body throws is rethrown here, after the others have finished or been skipped.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

}  // namespace velarium
