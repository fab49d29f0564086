#include "support.hpp"

#include "config.hpp"

#include <velarium/options.hpp>

namespace velarium::fuzz {
namespace {

// What an option took it must give back as text that it takes again.
void set(Settings& settings, const std::string& key, const std::string& value) {
  set_option(settings, key, value);
  const std::string kept = get_option(settings, key);
  set_option(settings, key, kept);
  if (get_option(settings, key) != kept) throw std::logic_error(key + " does not keep " + kept);
}

}  // namespace

void config(Bytes input) {
  static const InputFile file("input.toml");
  expect_orderly([&] {
    Settings settings;
    for (const app::ConfigEntry& entry : app::read_config(file.write(input))) {
      for (const std::string& value : entry.values) {
        expect_orderly([&] { set(settings, entry.table + "." + entry.key, value); });
      }
    }
  });
}

}  // namespace velarium::fuzz
