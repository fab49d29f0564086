#include "view_flags.hpp"

#include "console.hpp"
#include "parse.hpp"

namespace velarium::app {
namespace {

void add_camera_flags(Flags& flags, View& view) {
  flags.add({"--size", "WxH", "pixels of the picture [1280x720]", [&view](const std::string& text) {
               const auto [width, height] = parse_size(text);
               view.request.width = width;
               view.request.height = height;
             }});
  flags.add({"--camera", "NAME|INDEX|auto", "a camera of the scene, or one that fits it [the first, else auto]",
             [&view](const std::string& text) { view.request.camera = text; }});
  flags.add({"--eye", "X,Y,Z", "where a camera of your own stands, metres",
             [&view](const std::string& text) { view.eye = parse_point(text); }});
  flags.add({"--target", "X,Y,Z", "what that camera looks at [0,0,0]",
             [&view](const std::string& text) { view.target = parse_point(text); }});
  flags.add({"--up", "X,Y,Z", "what is up for that camera [0,1,0]",
             [&view](const std::string& text) { view.up = parse_point(text); }});
  flags.add({"--fov", "DEGREES", "that camera's vertical field of view [45]", [&view](const std::string& text) {
               const float degrees = parse_number(text);
               // A perspective picture needs an angle between nothing and a half-space.
               if (!(degrees > 0.0f && degrees < 180.0f)) {
                 throw Error(ErrorCode::usage, "'" + text + "' is not an angle between 0 and 180 degrees");
               }
               view.fov_deg = degrees;
             }});
}

void set_background(RenderRequest& request, const std::string& text) {
  if (text == "env") {
    request.background = Background::environment;
  } else if (text == "transparent") {
    request.background = Background::transparent;
  } else if (text.starts_with('#')) {
    request.background_color = parse_color(text);
    request.background = Background::color;
  } else {
    throw Error(ErrorCode::usage, "'" + text + "' is not one of env, transparent, #rrggbb");
  }
}

void add_light_flags(Flags& flags, View& view) {
  RenderRequest& request = view.request;
  flags.add({"--env", "FILE|studio|sky|white|none",
             "light from far away: .hdr or .exr [studio where the scene has no light]",
             [&request](const std::string& text) { request.environment = text; }});
  flags.add({"--sun", "AZ,EL[,LUX]",
             "a sun at so many degrees from +Z towards +X, and above the horizon; of so much light [none; 4 lux]",
             [&request](const std::string& text) { request.sun = parse_sun(text); }});
  flags.add_option("--env-rotate", "environment.rotation", "DEGREES");
  flags.add_option("--env-intensity", "environment.intensity", "X");
  flags.add({"--background", "env|transparent|#rrggbb", "what is seen behind the scene [env]",
             [&request](const std::string& text) { set_background(request, text); }});
}

void add_display_flags(Flags& flags, View& view) {
  Settings& settings = view.request.settings;
  flags.add({"--exposure", "STOPS|auto", option_help("display.exposure") + "; auto: by the picture",
             [&settings](const std::string& text) {
               const bool automatic = text == "auto";
               set_option(settings, automatic ? "display.exposure_mode" : "display.exposure",
                          automatic ? "automatic" : text);
             }});
  flags.add({"--ev100", "EV", option_help("display.ev100"), [&settings](const std::string& text) {
               set_option(settings, "display.ev100", text);
               set_option(settings, "display.exposure_mode", "ev100");
             }});
  flags.add_option("--tonemap", "display.tonemap");
}

}  // namespace

void add_view_flags(Flags& flags, View& view) {
  add_camera_flags(flags, view);
  add_light_flags(flags, view);
  add_display_flags(flags, view);
  RenderRequest& request = view.request;
  flags.add({"--time", "SECONDS", "snapshot of the animation [0]",
             [&request](const std::string& text) { request.time_s = parse_number(text); }});
  flags.add({"--animation", "NAME|INDEX|all", "which animation plays [the first]",
             [&request](const std::string& text) { request.animation = text; }});
  flags.add({"--variant", "NAME|INDEX|none", "a variant of the scene's materials [none]",
             [&view](const std::string& text) { view.load.variant = text; }});
  flags.add({"--device", "NAME|INDEX|cpu", "which device renders; part of a name will do [the best]",
             [&view](const std::string& text) { view.engine.device = text; }});
  flags.add({"--validation", "", "check the use of Vulkan; every message is an error",
             [&view](const std::string&) { view.engine.validation = true; }});
  flags.add({"--allow-outside-files", "", "a scene may name files outside its own folder",
             [&view](const std::string&) { view.load.allow_outside_files = true; }});
  flags.add({"--strict", "", "refuse a scene that breaks the rules of glTF, also where a repair would do",
             [&view](const std::string&) { view.load.strict = true; }});
}

void finish_view(View& view) {
  view.load.limits = view.request.settings.load;
  if (!view.eye) {
    const char* alone = view.target ? "--target" : view.up ? "--up" : view.fov_deg ? "--fov" : nullptr;
    if (alone != nullptr) throw Error(ErrorCode::usage, std::string(alone) + " needs --eye");
    return;
  }
  if (!view.request.camera.empty()) throw Error(ErrorCode::usage, "--camera and --eye exclude each other");
  LookAt look;
  look.eye = *view.eye;
  look.target = view.target.value_or(look.target);
  look.up = view.up.value_or(look.up);
  look.vertical_fov_deg = view.fov_deg.value_or(look.vertical_fov_deg);
  view.request.look_at = look;
}

std::filesystem::path picture_name(const std::string& scene) {
  const bool builtin = scene.starts_with("builtin:");
  const std::string plain = builtin ? scene.substr(0, scene.find('?')).substr(scene.find(':') + 1) : scene;
  std::filesystem::path name = std::filesystem::path(plain).stem();
  name += ".png";
  return name;
}

void add_verbosity_flags(CLI::App& verb) {
  auto* quiet = verb.add_flag_callback(
      "-q,--quiet", [] { set_verbosity(Verbosity::quiet); }, "say errors only");
  verb.add_flag_callback(
          "-v,--verbose", [] { set_verbosity(Verbosity::verbose); }, "say more")
      ->excludes(quiet);
}

}  // namespace velarium::app
