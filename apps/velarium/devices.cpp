#include "verbs.hpp"

#include "console.hpp"
#include "report.hpp"

#include <velarium/engine.hpp>

#include <fmt/core.h>

#include <memory>

namespace velarium::app {
namespace {

nlohmann::ordered_json json_of_devices(const std::vector<DeviceInfo>& devices) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const DeviceInfo& device : devices) {
    const DeviceLimits& limits = device.limits;
    json.push_back({{"index", device.index},
                    {"name", device.name},
                    {"kind", device.kind},
                    {"driver", device.driver},
                    {"api_version", device.api_version},
                    {"limits",
                     {{"samplers", limits.samplers},
                      {"sampled_images", limits.sampled_images},
                      {"storage_images", limits.storage_images},
                      {"storage_buffers", limits.storage_buffers},
                      {"bound_sets", limits.bound_sets},
                      {"push_constant_bytes", limits.push_constant_bytes}}},
                    {"usable", device.usable},
                    {"why_not", device.why_not}});
  }
  return json;
}

void list_all(bool json) {
  const std::vector<DeviceInfo> devices = list_devices();
  if (json) return write_json("-", json_of_devices(devices));
  if (devices.empty()) print("no Vulkan device\n");
  for (const DeviceInfo& device : devices) {
    print(fmt::format("{}: {} ({}, Vulkan {}, {}){}\n", device.index, device.name, device.kind, device.api_version,
                      device.driver, device.usable ? "" : "; not usable: " + device.why_not));
    const DeviceLimits& limits = device.limits;
    print(fmt::format("   a shader stage binds {} samplers, {} sampled images, {} storage images, {} storage buffers\n",
                      limits.samplers, limits.sampled_images, limits.storage_images, limits.storage_buffers));
  }
}

}  // namespace

void add_devices(CLI::App& app) {
  const auto json = std::make_shared<bool>(false);
  CLI::App& verb =
      add_verb(app, "devices", "list the Vulkan devices, and why one cannot be used", [json] { list_all(*json); });
  verb.add_flag("--json", *json, "as JSON");
}

}  // namespace velarium::app
