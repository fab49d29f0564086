// A program of someone else: usage: outside SCENE.gltf. Exits with 0 where everything held, 77 where no device can
// render.
#include <velarium/velarium.hpp>

#include <cstdio>
#include <cstdlib>

namespace {

void expect(bool held, const char* what) {
  if (held) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::exit(1);
}

// A public function that the library forgot to export does not link.
void use_what_needs_no_device() {
  velarium::set_log_sink([](velarium::LogLevel, std::string_view) {});
  velarium::Settings settings;
  velarium::set_option(settings, "frame.spp", "2");
  expect(velarium::get_option(settings, "frame.spp") == "2", "options are set");
  expect(!velarium::option_range(velarium::option_table().front()).empty(), "options have ranges");
  expect(!velarium::option_group_help("frame").empty(), "groups have help");
  const std::vector<std::string> names = velarium::Scene::builtin_names();
  expect(velarium::nearest_name("sphere", names) == "spheres", "the nearest name is found");
  expect(velarium::median<double>({3.0, 1.0, 2.0}) == 2.0, "the median stands in the middle");
  expect(velarium::Picture::stores_linear("a.exr"), "EXR stores linear light");
  expect(velarium::metric_table().size() == 6, "there are six metrics");
  velarium::Picture::check_destination("out.png");
  velarium::check_writable("out.txt");
  velarium::write_text("out.txt", "text");
  velarium::remove_unfinished_files();
}

void catch_errors() {
  try {
    (void)velarium::Scene::load("absent.gltf");
    expect(false, "an absent file throws");
  } catch (const velarium::Error& error) {
    expect(error.code() == velarium::ErrorCode::input_missing, "the code says that the file is missing");
    expect(error.file() == "absent.gltf", "the error names the file");
  }
}

velarium::ErrorCode code_of_loading(const char* file, const velarium::LoadOptions& options) {
  try {
    (void)velarium::Scene::load(file, options);
  } catch (const velarium::Error& error) { return error.code(); }
  return velarium::ErrorCode::internal;
}

void set_limits(const char* file) {
  velarium::LoadOptions options;
  options.limits.bytes = 10;
  expect(code_of_loading(file, options) == velarium::ErrorCode::input_invalid, "a limit refuses what exceeds it");
  options.limits.bytes = 0;
  expect(code_of_loading(file, options) == velarium::ErrorCode::usage, "a limit has a range");
}

void make_a_scene() {
  velarium::SceneDescription description{.meshes = {{.positions = {{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}}}}};
  expect(velarium::Scene::make(description).info().triangles == 1, "a scene is made in code");
  description.meshes[0].material = 7;
  try {
    (void)velarium::Scene::make(description);
    expect(false, "an index that leads nowhere throws");
  } catch (const velarium::Error& error) {
    expect(error.code() == velarium::ErrorCode::usage, "the code says that the program is wrong");
  }
}

velarium::RenderRequest request_of(std::uint32_t width, std::uint32_t height, float eye_z) {
  velarium::RenderRequest request{.width = width, .height = height};
  request.look_at = velarium::LookAt{.eye = {0, 0, eye_z}};
  request.settings.frame.spp = 1;
  return request;
}

void compare_pictures(const velarium::Picture& near, const velarium::Picture& far) {
  const velarium::Comparison found = velarium::compare(far, near);
  expect(!found.within(velarium::Metric::flip, 0.0), "other pictures differ");
  expect(found.value(velarium::Metric::rmse) > 0.0, "their values differ");
  const std::string page = velarium::comparison_page(far, near, found, {}, velarium::Metric::flip, 0.0);
  expect(page.starts_with("<!doctype html>"), "a page shows it");
  expect(velarium::error_picture(found).width == 64, "the error map is a picture");
  expect(velarium::load_picture("out.png").display == near.display, "a saved picture comes back");
}

void render_pictures(const velarium::Scene& scene) {
  velarium::Engine engine;
  const velarium::Picture near = engine.picture(scene, request_of(64, 32, 3));
  const velarium::Picture far = engine.picture(scene, request_of(64, 32, 9));
  const velarium::Picture other = engine.render(scene, request_of(40, 50, 3)).picture;
  expect(near.linear.size() == 64 * 32 * 4 && near.display.size() == 64 * 32 * 4, "64 x 32 pixels arrive");
  expect(other.display.size() == 40 * 50 * 4, "the same engine renders another size");
  expect(near.linear != far.linear, "a camera that moves sees something else");
  near.save("out.png");
  compare_pictures(near, far);

  velarium::Engine second;
  second.prepare(request_of(64, 32, 9));
  const velarium::Scene spheres = velarium::Scene::load("builtin:spheres");
  expect(second.picture(spheres, request_of(64, 32, 9)).linear != far.linear, "scenes differ");
  expect(second.picture(scene, request_of(64, 32, 3)).display == near.display, "two engines make equal bytes");
  second = std::move(engine);
  expect(second.picture(scene, request_of(64, 32, 3)).display == near.display, "an engine may be moved");
}

void trace_pictures(const velarium::Scene& scene) {
  velarium::ReferenceRequest request{.view = request_of(32, 16, 3)};
  request.view.settings.reference.spp = 1;
  const velarium::ReferenceResult traced = velarium::render_reference(scene, request);
  expect(traced.report.finished && traced.report.paths == 32 * 16, "every pixel has its path");
  expect(traced.picture.linear.size() == 32 * 16 * 4 && traced.picture.layers.size() == 6, "layers arrive");
  request.on_progress = [](const velarium::ReferenceProgress&) { return false; };
  expect(!velarium::render_reference(scene, request).report.finished, "a caller may stop it");
}

bool can_render() {
  for (const velarium::DeviceInfo& device : velarium::list_devices()) {
    if (device.usable) return true;
  }
  return false;
}

}  // namespace

int main(int, char** arguments) {
  use_what_needs_no_device();
  catch_errors();
  set_limits(arguments[1]);
  make_a_scene();
  const velarium::Scene scene = velarium::Scene::load(arguments[1]);
  expect(scene.info().triangles > 0, "the scene has triangles");
  trace_pictures(scene);
  if (!can_render()) return 77;
  render_pictures(scene);
}
