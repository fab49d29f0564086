// Two engines on two threads render one shared scene, while the log sink is called from both: equal requests give equal
// bytes. Returns 77 where no device can render.
#include <velarium/velarium.hpp>

#include <atomic>
#include <cstdio>
#include <exception>
#include <thread>
#include <vector>

namespace {

constexpr int kSkipped = 77;  // what ctest is told to take for a skipped test

using Pixels = std::vector<std::uint16_t>;

Pixels render(const velarium::Scene& scene) {
  velarium::Engine engine;
  velarium::RenderRequest request{.width = 48, .height = 32};
  request.settings.frame.spp = 1;
  Pixels pixels;
  for (int i = 0; i < 2; ++i) pixels = engine.picture(scene, request).display;
  return pixels;
}

void render_or_tell(const velarium::Scene& scene, Pixels& pixels) {
  try {
    pixels = render(scene);
  } catch (const std::exception& error) { std::fprintf(stderr, "%s\n", error.what()); }
}

int compare_threads() {
  std::atomic<int> remarks = 0;
  velarium::set_log_sink([&](velarium::LogLevel, std::string_view) { ++remarks; });
  const velarium::Scene scene = velarium::Scene::load("builtin:spheres");
  Pixels first, second;
  std::thread a([&] { render_or_tell(scene, first); });
  std::thread b([&] { render_or_tell(scene, second); });
  a.join();
  b.join();
  velarium::set_log_sink({});
  return !first.empty() && first == second ? 0 : 1;
}

bool can_render() {
  try {
    const velarium::Engine engine;
    return true;
  } catch (const velarium::Error&) { return false; }
}

}  // namespace

int main() {
  return can_render() ? compare_threads() : kSkipped;
}
