#pragma once

namespace velarium {
inline constexpr const char* kVersion = "0.1.0";
}
