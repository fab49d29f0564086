#!/bin/sh
# Runs a command with SwiftShader as the only Vulkan driver: on_swiftshader.sh COMMAND... Exit code 77: it is not installed.
icd=/usr/lib/chromium/vk_swiftshader_icd.json
if [ ! -f "$icd" ]; then
  echo "skipped: SwiftShader is not installed; it comes with Debian's package chromium"
  exit 77
fi
unset VELARIUM_TEST_DEVICE   # names a device of another driver
VK_DRIVER_FILES=$icd exec "$@"
