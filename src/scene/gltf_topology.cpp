#include "scene/gltf_topology.hpp"

namespace velarium::scene::gltf {

namespace {

using Indices = std::vector<std::uint32_t>;

Indices lines_of_strip(const Indices& strip, bool closed) {
  Indices list;
  list.reserve(2 * strip.size());
  for (std::size_t i = 0; i + 1 < strip.size(); ++i) list.insert(list.end(), {strip[i], strip[i + 1]});
  if (closed && strip.size() > 1) list.insert(list.end(), {strip.back(), strip.front()});
  return list;
}

Indices triangles_of_strip(const Indices& strip) {
  Indices list;
  list.reserve(3 * strip.size());
  for (std::size_t i = 0; i + 2 < strip.size(); ++i) {
    list.insert(list.end(), {strip[i], strip[i + 1 + i % 2], strip[i + 2 - i % 2]});
  }
  return list;
}

Indices triangles_of_fan(const Indices& fan) {
  Indices list;
  list.reserve(3 * fan.size());
  for (std::size_t i = 1; i + 1 < fan.size(); ++i) list.insert(list.end(), {fan[i], fan[i + 1], fan[0]});
  return list;
}

}  // namespace

Topology topology_of(Mode mode) {
  if (mode == Mode::points) return Topology::points;
  return mode < Mode::triangles ? Topology::lines : Topology::triangles;
}

std::size_t left_over(Mode mode, std::size_t count) {
  switch (mode) {
    case Mode::lines:
      return count % 2;
    case Mode::triangles:
      return count % 3;
    case Mode::line_loop:
    case Mode::line_strip:
      return count < 2 ? count : 0;
    case Mode::triangle_strip:
    case Mode::triangle_fan:
      return count < 3 ? count : 0;
    case Mode::points:
      break;
  }
  return 0;
}

Indices as_list(Mode mode, Indices indices) {
  indices.resize(indices.size() - left_over(mode, indices.size()));
  switch (mode) {
    case Mode::line_loop:
      return lines_of_strip(indices, true);
    case Mode::line_strip:
      return lines_of_strip(indices, false);
    case Mode::triangle_strip:
      return triangles_of_strip(indices);
    case Mode::triangle_fan:
      return triangles_of_fan(indices);
    default:
      return indices;
  }
}

}  // namespace velarium::scene::gltf
