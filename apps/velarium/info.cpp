#include "verbs.hpp"

#include "console.hpp"
#include "flags.hpp"
#include "report.hpp"
#include "view_flags.hpp"

#include <velarium/scene.hpp>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <array>
#include <memory>
#include <utility>

namespace velarium::app {
namespace {

class Info {
 public:
  void declare(CLI::App& verb);
  void run();

 private:
  std::string scene_;
  bool json_ = false;
  LoadOptions load_;
  Settings settings_;
  std::unique_ptr<Flags> flags_;
};

using Count = std::pair<const char*, std::uint64_t>;

std::array<Count, 13> counts_of(const SceneInfo& info) {
  return {{{"nodes", info.nodes},
           {"meshes", info.meshes},
           {"primitives", info.primitives},
           {"vertices", info.vertices},
           {"triangles", info.triangles},
           {"lines", info.lines},
           {"points", info.points},
           {"materials", info.materials},
           {"textures", info.textures},
           {"images", info.images},
           {"texels", info.texels},
           {"skins", info.skins},
           {"morph_targets", info.morph_targets}}};
}

nlohmann::ordered_json json_of_info(const SceneInfo& info) {
  nlohmann::ordered_json json{{"source", info.source}, {"generator", info.generator}};
  for (const auto& [name, count] : counts_of(info)) json[name] = count;
  json["bounds"] = {{"min", info.bounds_min}, {"max", info.bounds_max}};
  for (const char* list : {"animations", "cameras", "lights"}) json[list] = nlohmann::ordered_json::array();
  for (const auto& a : info.animations) {
    json["animations"].push_back({{"name", a.name}, {"duration_s", a.duration_s}, {"channels", a.channels}});
  }
  for (const auto& c : info.cameras) json["cameras"].push_back({{"name", c.name}, {"kind", c.kind}});
  for (const auto& l : info.lights) {
    json["lights"].push_back({{"name", l.name}, {"kind", l.kind}, {"color", l.color}, {"intensity", l.intensity}});
  }
  json["variants"] = info.variants;
  json["parameters"] = nlohmann::ordered_json::array();
  for (const auto& p : info.parameters) {
    json["parameters"].push_back({{"key", p.key},
                                  {"value", p.value},
                                  {"least", p.least},
                                  {"most", p.most},
                                  {"meaning", p.meaning},
                                  {"names", p.names}});
  }
  json["extensions_used"] = info.extensions_used;
  json["extensions_required"] = info.extensions_required;
  json["warnings"] = info.warnings;
  return json;
}

std::string point_text(const std::array<float, 3>& p) {
  return fmt::format("({:g}, {:g}, {:g})", p[0], p[1], p[2]);
}

std::string parameter_text(const SceneInfo::Parameter& p) {
  if (p.names.empty()) return fmt::format("{}={}, from {} to {}: {}", p.key, p.value, p.least, p.most, p.meaning);
  return fmt::format("{}={}, of {}: {}", p.key, p.names[p.value], fmt::join(p.names, ", "), p.meaning);
}

// A row of the listing: what is empty is left out.
void add_row(std::string& text, std::string_view name, const std::string& value) {
  if (!value.empty()) text += fmt::format("{:<14} {}\n", name, value);
}

std::string text_of_info(const SceneInfo& info) {
  std::string text;
  add_row(text, "scene", info.source);
  add_row(text, "generator", info.generator);
  for (const auto& [name, count] : counts_of(info)) add_row(text, name, count == 0 ? "" : std::to_string(count));
  add_row(text, "bounds", fmt::format("{} to {} m", point_text(info.bounds_min), point_text(info.bounds_max)));
  for (std::size_t i = 0; i < info.cameras.size(); ++i) {
    add_row(text, fmt::format("camera {}", i), fmt::format("'{}', {}", info.cameras[i].name, info.cameras[i].kind));
  }
  for (std::size_t i = 0; i < info.lights.size(); ++i) {
    const SceneInfo::Light& light = info.lights[i];
    const char* unit = light.kind == "directional" ? "lx" : "cd";
    add_row(text, fmt::format("light {}", i),
            fmt::format("'{}', {}, {:g} {}, colour {}", light.name, light.kind, light.intensity, unit,
                        point_text(light.color)));
  }
  for (std::size_t i = 0; i < info.animations.size(); ++i) {
    const SceneInfo::Animation& animation = info.animations[i];
    add_row(text, fmt::format("animation {}", i),
            fmt::format("'{}', {:g} s, {} channels", animation.name, animation.duration_s, animation.channels));
  }
  for (std::size_t i = 0; i < info.variants.size(); ++i) {
    add_row(text, fmt::format("variant {}", i), fmt::format("'{}'", info.variants[i]));
  }
  for (const auto& p : info.parameters) add_row(text, "parameter", parameter_text(p));
  add_row(text, "uses", fmt::format("{}", fmt::join(info.extensions_used, ", ")));
  add_row(text, "requires", fmt::format("{}", fmt::join(info.extensions_required, ", ")));
  return text;
}

void Info::declare(CLI::App& verb) {
  verb.add_option("SCENE", scene_, "a .gltf or .glb file, or builtin:NAME")->required();
  flags_ = std::make_unique<Flags>(verb, settings_);
  verb.add_flag("--json", json_, "as JSON");
  flags_->add({"--allow-outside-files", "", "a scene may name files outside its own folder",
               [this](const std::string&) { load_.allow_outside_files = true; }});
  flags_->add({"--strict", "", "refuse a scene that breaks the rules of glTF, also where a repair would do",
               [this](const std::string&) { load_.strict = true; }});
  add_verbosity_flags(verb);
}

void Info::run() {
  flags_->apply();
  load_.limits = settings_.load;
  const SceneInfo info = Scene::load(scene_, load_).info();
  if (json_) return write_json("-", json_of_info(info));
  print(text_of_info(info));
  for (const std::string& warning : info.warnings) say_warning(warning);
}

}  // namespace

void add_info(CLI::App& app) {
  const auto info = std::make_shared<Info>();
  info->declare(add_verb(app, "info", "tell what a scene holds; needs no GPU", [info] { info->run(); }));
}

}  // namespace velarium::app
