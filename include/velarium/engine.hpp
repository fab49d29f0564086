#pragma once

#include <velarium/look_at.hpp>
#include <velarium/picture.hpp>
#include <velarium/scene.hpp>
#include <velarium/settings.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace velarium {

// What one shader stage of a device may bind, and its pipelines.
struct DeviceLimits {
  std::uint32_t samplers = 0, sampled_images = 0, storage_images = 0, storage_buffers = 0;  // a stage
  std::uint32_t bound_sets = 0, push_constant_bytes = 0;
};

struct DeviceInfo {
  std::uint32_t index = 0;
  std::string name;         // as the driver says it
  std::string kind;         // "discrete", "integrated", "virtual", "cpu", "other"
  std::string driver;       // name and version
  std::string api_version;  // "1.3.224"
  DeviceLimits limits;
  bool usable = false;
  std::string why_not;  // what a device that is not usable lacks
};

// Every Vulkan device of this machine, usable or not. Throws Error(no_device) where no loader is installed.
[[nodiscard]] std::vector<DeviceInfo> list_devices();

struct EngineOptions {
  std::string device;       // name (or part of it), index, "cpu"; empty: the best usable one
  bool validation = false;  // Vulkan validation and synchronisation validation; messages become Error(internal)
};

// A sun beside the scene's own lights, as a disc at the sky.
struct Sun {
  float azimuth_deg = 45.0f;           // 0 is +Z, 90 is +X: it grows as environment.rotation does
  float elevation_deg = 35.0f;         // above the horizon, -90 to 90
  float illuminance_lux = 4.0f;        // on a plane that faces it: colours come out as they are without exposure
  float angular_radius_deg = 0.2666f;  // of the disc: the sun's seen from the earth; 0: one direction
};

enum class Background { environment, color, transparent };

struct RenderRequest {
  std::uint32_t width = 1280, height = 720;
  // Name or index of a camera of the scene, "auto" (fits the scene), or empty: the first, else auto.
  std::string camera;
  std::optional<LookAt> look_at;  // instead of `camera`
  std::string environment;  // file, "studio", "sky", "none"; empty: studio where the scene has no light, else none
  std::optional<Sun> sun;   // none: the scene's own lights alone
  Background background = Background::environment;
  std::array<float, 3> background_color{0, 0, 0};  // display values 0..1, sRGB-encoded
  float time_s = 0.0f;
  std::string animation;  // name, index, "all" or "none"; empty: the first
  Settings settings;
  bool want_linear = true, want_display = true;  // which halves of Picture to fill
  std::vector<std::string> dumps;                // "pass.image" names to bring back from the last frame
  std::function<void(std::uint32_t done, std::uint32_t of)> on_frame;  // after each frame, on the calling thread
};

struct PassTime {
  std::string name;
  double ms = 0;                  // median over the frames, the first excluded where there are several
  std::vector<double> frames_ms;  // each of those frames, in order
};

struct MapMemory {
  std::string name;         // "pass.image", as RenderRequest::dumps has it
  std::uint64_t bytes = 0;  // of device memory, with what the driver adds
};

struct RenderReport {
  double frame_ms = 0;            // device time of a frame: median, the first excluded where there are several
  std::vector<double> frames_ms;  // each of those frames, in order
  std::uint32_t frames = 0;
  std::vector<PassTime> passes;
  std::uint64_t device_bytes = 0;  // peak of device memory that this engine allocated
  // That the engine holds for this picture; together they are what shadows.memory bounds.
  std::vector<MapMemory> shadow_maps;
  std::string device;
  std::vector<std::string> notes;  // decisions a user should hear of, one sentence each
};

struct DumpedImage {
  std::string name;
  std::uint32_t width = 0, height = 0;
  std::vector<float> rgba;  // as stored, widened to float
};

struct RenderResult {
  Picture picture;
  RenderReport report;
  std::vector<DumpedImage> dumps;
};

// A device and what it keeps between pictures. Not thread-safe; several engines may live side by side.
class Engine {
 public:
  // Throws Error(no_device) that says, for each device, why it was refused.
  explicit Engine(const EngineOptions& options = {});
  ~Engine();
  Engine(Engine&&) noexcept;
  Engine& operator=(Engine&&) noexcept;

  // Does ahead what pictures of `request` need and no scene decides, where the request names its environment: bakes
  // that, makes tables, and lets the driver compile pipelines. Pictures are the same without it; it is worth a call on
  // a thread of its own while a scene loads (docs/library.md). Throws as render() does for the environment and the
  // settings.
  void prepare(const RenderRequest& request);
  [[nodiscard]] RenderResult render(const Scene& scene, const RenderRequest& request);
  // The picture alone.
  [[nodiscard]] Picture picture(const Scene& scene, const RenderRequest& request = {}) {
    return render(scene, request).picture;
  }

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace velarium
