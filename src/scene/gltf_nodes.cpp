#include "scene/gltf_parts.hpp"
#include "scene/gltf_transforms.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace velarium::scene::gltf {

namespace {

void read_transform(const Value& value, Node& node) {
  const Value matrix = value["matrix"], rotation = value["rotation"];
  if (matrix) {
    if (value["translation"] || rotation || value["scale"]) {
      matrix.fail("stands beside translation, rotation or scale; keep one of the two");
    }
    node.matrix = matrix.vector_or(glm::dmat4(1.0));
    check_affine(matrix, *node.matrix);
    return;
  }
  node.translation = value["translation"].vector_or(node.translation);
  node.scale = value["scale"].vector_or(node.scale);
  if (rotation) node.rotation = unit_rotation(rotation, rotation.vector_or(glm::vec4(0, 0, 0, 1)));
}

void read_node_weights(Context& context, const Value& value, Node& node) {
  const Value weights = value["weights"];
  if (!weights) return;
  if (node.mesh == kNone) {
    weights.repair("belong to a node without a mesh; they are ignored");
    return;
  }
  const std::uint32_t count = morph_target_count(context, static_cast<std::uint32_t>(node.mesh));
  if (weights.size() != count) {
    weights.fail(fmt::format("has {} weights, but its mesh has {} morph targets", weights.size(), count));
  }
  for (const Value& weight : weights.elements()) node.weights.push_back(weight.number());
}

Node read_node(Context& context, const Value& value, std::uint32_t node_count) {
  Node node;
  node.name = value["name"].text_or("");
  read_transform(value, node);
  node.mesh = value["mesh"].reference_or_none(context.root["meshes"].size(), "meshes");
  node.camera = value["camera"].reference_or_none(context.root["cameras"].size(), "cameras");
  const Value skin = value["skin"];
  node.skin = skin.reference_or_none(context.root["skins"].size(), "skins");
  if (skin && node.mesh == kNone) {
    skin.repair("belongs to a node without a mesh; it is ignored");
    node.skin = kNone;
  }
  read_node_weights(context, value, node);
  for (const Value& child : value["children"].elements()) node.children.push_back(child.reference(node_count, "nodes"));
  read_extensions(context, value, &Extension::node, node);
  return node;
}

void set_parents(const std::vector<Value>& values, std::vector<Node>& nodes) {
  for (std::uint32_t parent = 0; parent < nodes.size(); ++parent) {
    for (std::uint32_t i = 0; i < nodes[parent].children.size(); ++i) {
      Node& child = nodes[nodes[parent].children[i]];
      if (child.parent != kNone) {
        values[parent]["children"].at(i).fail(
            fmt::format("node {} is already a child of node {}", nodes[parent].children[i], child.parent));
      }
      child.parent = static_cast<std::int32_t>(parent);
    }
  }
}

// Each node has at most one parent, so whatever the roots do not reach is in a loop or below one.
void check_forest(const std::vector<Value>& values, const std::vector<Node>& nodes, std::uint64_t max_depth) {
  const Budget levels("load.depth", max_depth);
  std::vector<std::uint32_t> depth(nodes.size(), 0), open;  // depth 0: not reached yet
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].parent != kNone) continue;
    depth[i] = 1;
    open.push_back(i);
  }
  while (!open.empty()) {
    const std::uint32_t parent = open.back();
    open.pop_back();
    for (const std::uint32_t child : nodes[parent].children) {
      depth[child] = depth[parent] + 1;
      if (!levels.fits(depth[child])) values[child].fail("lies at a depth of " + levels.refusal(depth[child]));
      open.push_back(child);
    }
  }
  const auto lost = std::ranges::find(depth, 0u);
  if (lost != depth.end()) values[static_cast<std::size_t>(lost - depth.begin())].fail("is part of a loop of nodes");
}

// `listed_in` holds, for each node, the number of the last scene that listed it; this one's is `number`.
std::vector<std::uint32_t> read_scene_roots(const Value& value, const std::vector<Node>& nodes, std::size_t number,
                                            std::vector<std::size_t>& listed_in) {
  std::vector<std::uint32_t> roots;
  for (const Value& entry : value["nodes"].elements()) {
    const std::uint32_t root = entry.reference(static_cast<std::uint32_t>(nodes.size()), "nodes");
    if (nodes[root].parent != kNone) {
      entry.fail(fmt::format("node {} is a child of node {}, not a root", root, nodes[root].parent));
    }
    if (listed_in[root] == number) entry.fail(fmt::format("node {} is listed twice", root));
    listed_in[root] = number;
    roots.push_back(root);
  }
  return roots;
}

}  // namespace

void read_nodes(Context& context) {
  const Value list = context.root["nodes"];
  const std::vector<Value> values = list.elements();
  const Budget budget("load.nodes", context.options.limits.nodes);
  if (!budget.fits(values.size())) list.fail("has " + budget.refusal(values.size()));
  std::vector<Node>& nodes = context.scene.nodes;
  nodes.reserve(values.size());
  for (const Value& value : values) {
    nodes.push_back(read_node(context, value, static_cast<std::uint32_t>(values.size())));
  }
  set_parents(values, nodes);
  check_forest(values, nodes, context.options.limits.depth);
}

void read_scenes(Context& context) {
  const std::vector<Node>& nodes = context.scene.nodes;
  const std::vector<Value> scenes = context.root["scenes"].elements();
  const std::int32_t shown =
      context.root["scene"].reference_or_none(static_cast<std::uint32_t>(scenes.size()), "scenes");
  std::vector<std::size_t> listed_in(nodes.size(), 0);
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    std::vector<std::uint32_t> roots = read_scene_roots(scenes[i], nodes, i + 1, listed_in);
    if (i == static_cast<std::size_t>(std::max(shown, 0))) context.scene.roots = std::move(roots);
  }
  if (!scenes.empty()) return;
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {  // a library of nodes: all of them are shown
    if (nodes[i].parent == kNone) context.scene.roots.push_back(i);
  }
}

}  // namespace velarium::scene::gltf
