#include "frame/check_request.hpp"

#include <velarium/error.hpp>
#include <velarium/options.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace velarium::frame {
namespace {

void check_size(const RenderRequest& request, std::uint32_t limit) {
  if (request.width == 0 || request.height == 0 || std::max(request.width, request.height) > limit)
    throw Error(ErrorCode::usage,
                fmt::format("a picture of {}x{} pixels cannot be made: the device takes 1 to {} a side", request.width,
                            request.height, limit));
}

// Programs set members of Settings directly. Their texts, read back, go through the checks of the options table.
void check_settings(const Settings& settings) {
  Settings read_back;
  for (const auto& option : option_table()) set_option(read_back, option.key, get_option(settings, option.key));
  if (settings.output.bits != 8 && settings.output.bits != 16)
    throw Error(ErrorCode::usage, fmt::format("output.bits is {}; choose 8 or 16", settings.output.bits));
}

// The comparisons are false for what is not a number.
void check_view(const RenderRequest& request) {
  if (request.look_at) {
    const float fov = request.look_at->vertical_fov_deg;
    if (!(fov > 0.0f && fov < 180.0f))
      throw Error(ErrorCode::usage, fmt::format("a field of view of {} degrees; choose one between 0 and 180", fov));
  }
  for (const float channel : request.background_color)
    if (!(channel >= 0.0f && channel <= 1.0f))
      throw Error(ErrorCode::usage, fmt::format("a background colour of {}; choose values from 0 to 1", channel));
  if (!std::isfinite(request.time_s))
    throw Error(ErrorCode::usage, fmt::format("a time of {} seconds; choose a number", request.time_s));
}

void check_sun(const Sun& sun) {
  const bool high = std::abs(sun.elevation_deg) <= 90.0f, bright = sun.illuminance_lux >= 0.0f;
  const bool small = sun.angular_radius_deg >= 0.0f && sun.angular_radius_deg < 90.0f;
  if (!std::isfinite(sun.azimuth_deg) || !high || !bright || !std::isfinite(sun.illuminance_lux) || !small)
    throw Error(ErrorCode::usage,
                fmt::format("a sun at azimuth {} and elevation {} degrees, of {} lux and radius {} degrees; choose an "
                            "elevation from -90 to 90, 0 lux or more, and a radius from 0 to less than 90",
                            sun.azimuth_deg, sun.elevation_deg, sun.illuminance_lux, sun.angular_radius_deg));
}

}  // namespace

void check_request(const RenderRequest& request, std::uint32_t size_limit) {
  check_size(request, size_limit);
  check_settings(request.settings);
  check_view(request);
  if (request.sun) check_sun(*request.sun);
}

}  // namespace velarium::frame
