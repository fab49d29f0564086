#pragma once

#include "graph/executor.hpp"

#include <velarium/engine.hpp>

#include <vector>

namespace velarium::frame {

// Gathers the times of a picture's frames. Medians leave the first frame out where there are several: it makes
// pipelines and fills caches.
class Timings {
 public:
  void add_frame(const std::vector<graph::PassTiming>& passes);
  void write(RenderReport& report) const;

 private:
  std::vector<std::vector<graph::PassTiming>> frames_;
};

}  // namespace velarium::frame
